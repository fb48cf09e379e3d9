using System.Collections.Generic;
using UnityEngine;

namespace Headless.Engine;

/// <summary>The pool behind RenderTexture.GetTemporary; textures unused for some frames are freed.</summary>
internal static class TemporaryTextures
{
    private const int KeptFrames = 15;
    private static readonly List<(RenderTexture Texture, int Age)> Free = [];
    private static readonly HashSet<RenderTexture> Used = [];

    public static RenderTexture Get(RenderTextureDescriptor desc)
    {
        Free.RemoveAll(f => f.Texture == null);
        int index = Free.FindIndex(f => f.Texture.descriptor.Equals(desc));
        RenderTexture texture;
        if (index >= 0)
        {
            texture = Free[index].Texture;
            Free.RemoveAt(index);
            texture.DiscardContents();
        }
        else
        {
            texture = new RenderTexture(desc) { name = $"TempBuffer {desc.width}x{desc.height}", hideFlags = HideFlags.HideAndDontSave };
        }

        texture.filterMode = FilterMode.Bilinear;
        texture.wrapMode = TextureWrapMode.Clamp;
        texture.Create();
        Used.Add(texture);
        return texture;
    }

    public static void Release(RenderTexture? texture)
    {
        if (texture is not null && Used.Remove(texture))
        {
            Free.Add((texture, 0));
        }
    }

    public static void EndFrame()
    {
        for (int i = Free.Count - 1; i >= 0; i--)
        {
            (RenderTexture texture, int age) = Free[i];
            if (age >= KeptFrames)
            {
                Free.RemoveAt(i);
                texture.Kill();
            }
            else
            {
                Free[i] = (texture, age + 1);
            }
        }
    }

    public static void Reset()
    {
        Free.Clear();
        Used.Clear();
    }
}
