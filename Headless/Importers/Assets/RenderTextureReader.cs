using Headless.Importers.Scenes;
using UnityEngine;
using UnityEngine.Experimental.Rendering;

namespace Headless.Importers.Assets;

/// <summary>.renderTexture assets.</summary>
internal static class RenderTextureReader
{
    public static RenderTexture Create(NativeFields f)
    {
        int width = f.Int("m_Width", 256), height = f.Int("m_Height", 256);
        if (width < 1 || height < 1) throw new FormatException($"a render texture of {width} x {height} pixels cannot be made; set its size to at least 1 x 1.");
        GraphicsFormat colour = (GraphicsFormat)f.Int("m_ColorFormat", (int)GraphicsFormat.R8G8B8A8_UNorm);
        int depth = f.Int("m_DepthStencilFormat") != 0 ? 24 : 0;
        NativeFields sampling = f.Nested("m_TextureSettings");
        return new RenderTexture(width, height, depth, colour)
        {
            antiAliasing = Math.Max(1, f.Int("m_AntiAliasing", 1)),
            useMipMap = f.Bool("m_MipMap"),
            autoGenerateMips = f.Bool("m_GenerateMips", true),
            enableRandomWrite = f.Bool("m_EnableRandomWrite"),
            filterMode = (FilterMode)sampling.Int("m_FilterMode", 1),
            wrapMode = (TextureWrapMode)sampling.Int("m_WrapU", 1),
        };
    }
}
