using UnityEngine;

namespace Headless.Engine;

/// <summary>The background where a camera clears to the skybox: the scene's skybox material or a plain gradient.</summary>
internal static class Sky
{
    // What surfaces that face up, sideways and down receive from it, linear; about as bright as Unity's default sky.
    public static readonly Color AmbientUp = new(0.15f, 0.18f, 0.23f);
    public static readonly Color AmbientLevel = new(0.11f, 0.12f, 0.14f);
    public static readonly Color AmbientDown = new(0.05f, 0.045f, 0.04f);

    // Linear colors of the gradient.
    private static readonly Color Zenith = new(0.16f, 0.27f, 0.48f);
    private static readonly Color Horizon = new(0.60f, 0.68f, 0.76f);
    private static readonly Color Ground = new(0.20f, 0.19f, 0.18f);

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
