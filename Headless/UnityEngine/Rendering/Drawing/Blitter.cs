using UnityEngine;

namespace Headless.Engine;

/// <summary>Draws a texture over a whole target, as Graphics.Blit does.</summary>
internal static class Blitter
{
    private static readonly int ScaleOffset = ShaderNames.Id("_MainTex_ST");
    private static readonly int SourceSlice = ShaderNames.Id("_Slice");
    private static Material? copy;
    private static Material? copySlice;
    private static Mesh? quad;

    /// <param name="slice">Of a source that is an array, where the target is none; each slice of the target has that of the source.</param>
    public static void Blit(
        Texture? source, DrawTarget? target, Material? material, int pass, Vector2 scale, Vector2 offset, Rect? viewport = null, int slice = 0)
    {
        if (target is null)
        {
            return;
        }

        if (target.IsLayered)
        {
            for (int i = 0; i < target.Any.Description.Layers; i++)
            {
                Blit(source, target.Layer(i), material, pass, scale, offset, viewport, i);
            }

            return;
        }

        bool plain = material == null;
        if (plain)
        {
            material = source is { dimension: UnityEngine.Rendering.TextureDimension.Tex2DArray } ? CopySlice : Copy;
            pass = 0;
        }

        var block = new PropertySheet();
        block.SetFloat(SourceSlice, slice);
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

    public static void Reset() => (copy, copySlice, quad) = (null, null, null);

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

    private static Material CopySlice
    {
        get
        {
            if (copySlice == null)
            {
                copySlice = new Material(Copy) { hideFlags = HideFlags.HideAndDontSave };
                copySlice.EnableKeyword("SOURCE_ARRAY");
            }

            return copySlice;
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
