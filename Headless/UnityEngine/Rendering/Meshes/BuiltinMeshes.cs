using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;

namespace Headless.Engine;

/// <summary>Unity's primitive meshes, made when first asked for.</summary>
internal static class BuiltinMeshes
{
    private static readonly Dictionary<PrimitiveType, Mesh> Meshes = [];

    public static Mesh Get(PrimitiveType type)
    {
        if (!Meshes.TryGetValue(type, out Mesh? mesh) || mesh == null)
        {
            mesh = PrimitiveShapes.Build(type);
            mesh.name = type.ToString();
            mesh.hideFlags = HideFlags.NotEditable;
            mesh.IsPersistent = true;
            Meshes[type] = mesh;
        }

        return mesh;
    }

    public static void FillPrimitive(GameObject target, PrimitiveType type)
    {
        target.AddComponent<MeshFilter>().sharedMesh = Get(type);
        target.AddComponent<MeshRenderer>().sharedMaterial =
            GraphicsSettings.currentRenderPipeline?.defaultMaterial is { } own && own != null ? own : BuiltinResources.DefaultMaterial;
    }

    public static void Reset() => Meshes.Clear();
}
