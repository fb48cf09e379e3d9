using System;
using System.Runtime.InteropServices;
using Headless.Engine;

namespace UnityEngine;

[Serializable]
[StructLayout(LayoutKind.Sequential)]
public struct LayerMask
{
    int m_Mask;

    public int value { readonly get => m_Mask; set => m_Mask = value; }

    public static implicit operator int(LayerMask mask) => mask.m_Mask;
    public static implicit operator LayerMask(int intVal) => new() { m_Mask = intVal };

    public static string LayerToName(int layer) => TagManager.LayerName(layer);
    public static int NameToLayer(string layerName) => TagManager.LayerIndex(layerName);

    public static int GetMask(params string[] layerNames)
    {
        ArgumentNullException.ThrowIfNull(layerNames);
        int mask = 0;
        foreach (string name in layerNames)
        {
            int layer = NameToLayer(name);
            if (layer != -1) mask |= 1 << layer;
        }
        return mask;
    }
}
