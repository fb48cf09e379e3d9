using UnityEngine.Rendering;
using UnityEngine;

namespace Headless.Engine;

/// <summary>The reflection variables of shaders. One probe an object: Unity's blend of two is not made.</summary>
internal static class ReflectionSettings
{
    private static readonly int[] Textures = [ShaderNames.Id("unity_SpecCube0"), ShaderNames.Id("unity_SpecCube1")];
    private static readonly int[] Decodes = [ShaderNames.Id("unity_SpecCube0_HDR"), ShaderNames.Id("unity_SpecCube1_HDR")];
    private static readonly int[] Positions = [ShaderNames.Id("unity_SpecCube0_ProbePosition"), ShaderNames.Id("unity_SpecCube1_ProbePosition")];
    private static readonly int[] Minima = [ShaderNames.Id("unity_SpecCube0_BoxMin"), ShaderNames.Id("unity_SpecCube1_BoxMin")];
    private static readonly int[] Maxima = [ShaderNames.Id("unity_SpecCube0_BoxMax"), ShaderNames.Id("unity_SpecCube1_BoxMax")];

    /// <summary>For what is drawn by command buffers: no probe.</summary>
    public static void ApplyDefault()
    {
        SetDefault(0);
        SetDefault(1);
    }

    /// <summary>Without probes (usage Off) surfaces mirror the sky.</summary>
    public static void Apply(ReflectionProbeUsage usage, in Bounds bounds)
    {
        ReflectionProbe? probe = usage == ReflectionProbeUsage.Off ? null : ReflectionProbeList.For(bounds);
        if (probe is null)
        {
            SetDefault(0);
            return;
        }

        Vector3 position = probe.transform.position;
        Bounds box = probe.bounds;
        Set(0, probe.texture!, probe.textureHDRDecodeValues, new Vector4(position.x, position.y, position.z, probe.boxProjection ? 1f : 0f), box.min, box.max);
    }

    private static void SetDefault(int index)
    {
        var nowhere = new Vector3(float.NegativeInfinity, float.NegativeInfinity, float.NegativeInfinity);
        Set(index, DefaultReflection.Texture, DefaultReflection.HdrDecode, default, nowhere, -nowhere);
    }

    private static void Set(int index, Texture texture, Vector4 decode, Vector4 position, Vector3 min, Vector3 max)
    {
        PropertySheet sheet = GlobalProperties.Sheet;
        sheet.SetTexture(Textures[index], new TextureSlot(texture));
        sheet.SetVector(Decodes[index], decode);
        sheet.SetVector(Positions[index], position);

        // w of the minimum is the first probe's share of the blend.
        sheet.SetVector(Minima[index], new Vector4(min.x, min.y, min.z, 1f));
        sheet.SetVector(Maxima[index], new Vector4(max.x, max.y, max.z, 0f));
    }
}
