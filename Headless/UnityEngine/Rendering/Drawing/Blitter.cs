using UnityEngine;

namespace Headless.Engine;

/// <summary>Draws a texture over a whole target, as Graphics.Blit does.</summary>
internal static class Blitter
{
    private static readonly int ScaleOffset = ShaderNames.Id("_MainTex_ST");
    private static Material? copy;
    private static Mesh? quad;

    public static void Blit(Texture? source, DrawTarget? target, Material? material, int pass, Vector2 scale, Vector2 offset, Rect? viewport = null)
    {
        if (target is null)
        {
            return;
        }

        bool plain = material == null;
        if (plain)
        {
            material = Copy;
            pass = 0;
        }

        var block = new PropertySheet();
        if (source != null)
        {
            block.SetTexture(BuiltinNames.MainTex, new TextureSlot(source));
        }

        if (plain)
        {
            // The screen's first row is the top of the picture, a texture's the bottom.
            bool turned = source is { BottomFirst: false };
            block.SetVector(ScaleOffset, turned
                ? new Vector4(scale.x, -scale.y, offset.x, 1f - offset.y)
                : new Vector4(scale.x, scale.y, offset.x, offset.y));
        }

        DrawTarget? before = TargetState.Current;
        Matrix4x4 view = ViewState.View;
        Matrix4x4 projection = ViewState.Projection;

        // A blit neither tests nor writes the target's depth.
        TargetState.Set(new DrawTarget
        {
            Colors = target.Colors,
            Resolves = target.Resolves,
            MipLevel = target.MipLevel,
            Slice = target.Slice,
            Flipped = target.Flipped,
        });
        TargetState.SetViewport(viewport);
        ViewState.Set(Matrix4x4.identity, Matrix4x4.Ortho(0f, 1f, 0f, 1f, -1f, 100f));
        Drawer.Draw(material!, pass, block, new MeshGeometry(Quad, 0, 1), Matrix4x4.identity);
        TargetState.Set(before);
        ViewState.Set(view, projection);
    }

    public static void Reset() => (copy, quad) = (null, null);

    private static Material Copy
    {
        get
        {
            if (copy == null)
            {
                copy = new Material(ShaderLibrary.Require("Hidden/BlitCopy")) { hideFlags = HideFlags.HideAndDontSave };
            }

            return copy;
        }
    }

    private static Mesh Quad
    {
        get
        {
            if (quad == null)
            {
                quad = new Mesh
                {
                    name = "Blit quad",
                    hideFlags = HideFlags.HideAndDontSave,
                    vertices = [new Vector3(0f, 0f, 0.1f), new Vector3(0f, 1f, 0.1f), new Vector3(1f, 1f, 0.1f), new Vector3(1f, 0f, 0.1f)],
                    uv = [new Vector2(0f, 0f), new Vector2(0f, 1f), new Vector2(1f, 1f), new Vector2(1f, 0f)],
                    triangles = [0, 1, 2, 0, 2, 3],
                };
            }

            return quad;
        }
    }
}
