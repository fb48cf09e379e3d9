using UnityEngine;

namespace Headless.Engine;

/// <summary>The background where a camera clears to the skybox: the scene's skybox material or a plain gradient.</summary>
internal static class Sky
{
    // Linear colors of the gradient, which the ambient light follows.
    public static readonly Color Zenith = new(0.16f, 0.27f, 0.48f);
    public static readonly Color Horizon = new(0.60f, 0.68f, 0.76f);
    public static readonly Color Ground = new(0.20f, 0.19f, 0.18f);

    private static readonly int ZenithId = ShaderNames.Id("_SkyZenith");
    private static readonly int HorizonId = ShaderNames.Id("_SkyHorizon");
    private static readonly int GroundId = ShaderNames.Id("_SkyGround");
    private static Material? material;

    public static void Draw()
    {
        if (material == null)
        {
            material = new Material(ShaderLibrary.Require("Hidden/Internal-Skybox")) { hideFlags = HideFlags.HideAndDontSave };
        }

        var block = new PropertySheet();
        block.SetVector(ZenithId, Zenith);
        block.SetVector(HorizonId, Horizon);
        block.SetVector(GroundId, Ground);
        Drawer.Draw(material, 0, block, new ProceduralGeometry(MeshTopology.Triangles, 3, 1), Matrix4x4.identity);
    }

    public static void Reset() => material = null;
}
