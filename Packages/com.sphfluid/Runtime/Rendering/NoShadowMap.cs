using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// A shadow map of one texel for the names that no pipeline has set: shaders that compare with a map name it even where they are told
    /// not to read it, and graphics APIs such as Vulkan and Metal want a depth texture there. The Universal Render Pipeline sets its own
    /// for every camera.
    /// </summary>
    internal static class NoShadowMap
    {
        [OutlivesPlay("one texel that serves every play")] private static RenderTexture map;

        /// <summary>Sets it under both names, once.</summary>
        public static void Bind()
        {
            if (map != null || !SystemInfo.SupportsRenderTextureFormat(RenderTextureFormat.Shadowmap)) return;
            map = new RenderTexture(1, 1, 16, RenderTextureFormat.Shadowmap)
            {
                name = "No Shadow Map",
                hideFlags = HideFlags.HideAndDontSave
            };
            map.Create();
            Shader.SetGlobalTexture(RenderShaderIds.MainLightShadowmap, map);
            Restore();
        }

        /// <summary>Sets it where the package's own map was, which is the light's and gone with it.</summary>
        public static void Restore() => Shader.SetGlobalTexture(RenderShaderIds.FluidShadowMap, map);
    }
}
