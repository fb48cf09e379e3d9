using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

namespace SphFluid
{
    /// <summary>
    /// The Universal Render Pipeline: <c>_CameraOpaqueTexture</c> and <c>_CameraDepthTexture</c>, asked for by a pass that is put into the
    /// camera's renderer each frame. No change of the project's pipeline assets is needed.
    /// </summary>
    internal sealed class UniversalSceneTextures : ISceneTextureSource
    {
        private BehindWaterPass pass;
        private CausticsPass caustics;

        public RendererLimit Limit => LimitOf((GraphicsSettings.currentRenderPipeline as UniversalRenderPipelineAsset)?.scriptableRenderer);

        public SceneTextures Request(Camera camera)
        {
            ScriptableRenderer renderer = camera.GetUniversalAdditionalCameraData().scriptableRenderer;
            if (renderer == null || LimitOf(renderer) != RendererLimit.None) return default;
            renderer.EnqueuePass(pass ??= new BehindWaterPass());
            if (WaterCaustics.AreSeenBy(camera)) renderer.EnqueuePass(caustics ??= new CausticsPass());
            return new SceneTextures(SceneColourSource.OpaqueTexture, true);
        }

        // A renderer forgets its passes after each camera.
        public void Release()
        {
            pass?.Release();
            pass = null;
        }

        private static RendererLimit LimitOf(ScriptableRenderer renderer)
        {
            // No public class, and in URP 17 of an assembly of its own.
            if (!(renderer is UniversalRenderer))
            {
                return renderer?.GetType().Name == "Renderer2D" ? RendererLimit.TwoDimensional : RendererLimit.None;
            }
#if UNITY_6000_5_OR_NEWER && !PLATFORM_WEBGL // where URP leaves the mode off
            UniversalRenderPipelineAsset asset = UniversalRenderPipeline.asset;
            for (int i = 0; i < asset.renderers.Length; i++)
            {
                if (asset.renderers[i] == renderer && asset.rendererDataList[i] is UniversalRendererData data && data.tileOnlyMode)
                {
                    return RendererLimit.TileOnly;
                }
            }
#endif
            return RendererLimit.None;
        }

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
#if UNITY_EDITOR
        [UnityEditor.InitializeOnLoadMethod]
#endif
        private static void Register() => WaterCameras.Universal = new UniversalSceneTextures();
    }
}
