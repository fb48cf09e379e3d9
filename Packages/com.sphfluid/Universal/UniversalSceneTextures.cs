using UnityEngine;
using UnityEngine.Rendering.Universal;

namespace SphFluid
{
    /// <summary>
    /// The Universal Render Pipeline: <c>_CameraOpaqueTexture</c> and <c>_CameraDepthTexture</c>, asked for by a pass that is put into the
    /// camera's renderer each frame. No change of the project's pipeline assets is needed.
    /// </summary>
    internal sealed class UniversalSceneTextures : ISceneTextureSource
    {
        private readonly BehindWaterPass pass = new BehindWaterPass();

        public SceneTextures Request(Camera camera)
        {
            ScriptableRenderer renderer = camera.GetUniversalAdditionalCameraData().scriptableRenderer;
            if (renderer == null) return default;
            renderer.EnqueuePass(pass);
            return new SceneTextures(SceneColourSource.OpaqueTexture, true);
        }

        // A renderer forgets its passes after each camera.
        public void Release() => pass.Release();

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
#if UNITY_EDITOR
        [UnityEditor.InitializeOnLoadMethod]
#endif
        private static void Register() => WaterCameras.Universal = new UniversalSceneTextures();
    }
}
