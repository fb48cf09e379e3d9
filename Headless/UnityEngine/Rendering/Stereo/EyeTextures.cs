using UnityEngine;
using UnityEngine.Rendering;

namespace Headless.Engine;

/// <summary>What the eyes are drawn into: a texture each, or the two slices of one.</summary>
internal static class EyeTextures
{
    private static readonly RenderTexture?[] Textures = new RenderTexture?[2];

    public static RenderTextureDescriptor Description
    {
        get
        {
            bool instanced = Stereo.Mode == StereoMode.Instanced;
            var description = new RenderTextureDescriptor(Stereo.EyeWidth, Stereo.EyeHeight, RenderTextureFormat.ARGB32, 24)
            {
                // One sample a slice: llvmpipe resolves a single slice only where it is the first.
                msaaSamples = !instanced && GraphicsSettings.currentRenderPipeline is null && QualitySettings.antiAliasing is 2 or 4 or 8 ? QualitySettings.antiAliasing : 1,
                dimension = instanced ? TextureDimension.Tex2DArray : TextureDimension.Tex2D,
                volumeDepth = instanced ? 2 : 1,
                vrUsage = instanced ? VRTextureUsage.TwoEyes : VRTextureUsage.OneEye,
            };
            description.msaaSamples = SystemInfo.GetRenderTextureSupportedMSAASampleCount(description);
            return description;
        }
    }

    /// <summary>That of the eyes that are drawn now.</summary>
    public static RenderTexture Current => Get(Stereo.Eyes[0]);

    public static DrawTarget Target => DrawTarget.Of(Current, 0, RenderTargetIdentifier.AllDepthSlices);

    /// <summary>Brings eyes to their halves of the screen.</summary>
    public static void Show(StereoTargetEyeMask mask)
    {
        for (int eye = 0; eye < Textures.Length; eye++)
        {
            if ((mask & (StereoTargetEyeMask)(1 << eye)) != 0)
            {
                var half = new Rect(eye * Stereo.EyeWidth, 0f, Stereo.EyeWidth, Stereo.EyeHeight);
                Blitter.Blit(Get((Camera.StereoscopicEye)eye), DrawTarget.Screen, null, 0, Vector2.one, Vector2.zero, half, eye);
            }
        }
    }

    public static void Reset() => (Textures[0], Textures[1]) = (null, null);

    private static RenderTexture Get(Camera.StereoscopicEye eye)
    {
        ref RenderTexture? texture = ref Textures[Stereo.Mode == StereoMode.Instanced ? 0 : (int)eye];
        if (texture == null || !texture.descriptor.Equals(Description))
        {
            UnityEngine.Object.DestroyImmediate(texture);
            texture = new RenderTexture(Description) { name = $"Eye texture {eye}", hideFlags = HideFlags.HideAndDontSave };
        }

        return texture;
    }
}
