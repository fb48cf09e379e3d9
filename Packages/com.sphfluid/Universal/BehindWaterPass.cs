using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;
#if UNITY_6000_0_OR_NEWER
using UnityEngine.Rendering.RenderGraphModule;
#endif

namespace SphFluid
{
    /// <summary>
    /// Makes the pipeline copy the opaque scene's colour and depth before transparent things are drawn, and draws what is seen through
    /// water into the copy, so that the water refracts it.
    /// </summary>
    internal sealed class BehindWaterPass : ScriptableRenderPass
    {
        [OutlivesPlay("it is a name in the profiler")]
        private static readonly ProfilingSampler sampler = new ProfilingSampler("Fluid Behind Water");

        public BehindWaterPass()
        {
            renderPassEvent = RenderPassEvent.BeforeRenderingTransparents;
            ConfigureInput(ScriptableRenderPassInput.Color | ScriptableRenderPassInput.Depth);
        }

        // In 6000.3 without the render graph only where a project asks for it; from 6000.4 on never, whatever define is left over.
#if !UNITY_6000_3_OR_NEWER || (URP_COMPATIBILITY_MODE && !UNITY_6000_4_OR_NEWER)
#pragma warning disable CS0618, CS0672 // marked obsolete from 6000.0 on, and called all the same in compatibility mode
        private static readonly int opaqueTexture = Shader.PropertyToID("_CameraOpaqueTexture");

        // The pipeline does not hand out its opaque texture here: the picture is copied again, and takes its name.
        private RTHandle copy;

        public override void OnCameraSetup(CommandBuffer cmd, ref RenderingData renderingData)
        {
            if (!IsNeeded(renderingData.cameraData.camera)) return;
            RenderTextureDescriptor descriptor = renderingData.cameraData.cameraTargetDescriptor;
            descriptor.depthBufferBits = 0;
            descriptor.msaaSamples = 1;
            RenderingUtils.ReAllocateIfNeeded(ref copy, descriptor, FilterMode.Bilinear, TextureWrapMode.Clamp, name: "Fluid Scene Colour");
            ConfigureTarget(copy);
        }

        public override void Execute(ScriptableRenderContext context, ref RenderingData renderingData)
        {
            Camera camera = renderingData.cameraData.camera;
            if (!IsNeeded(camera)) return;
            CommandBuffer cmd = CommandBufferPool.Get();
            using (new ProfilingScope(cmd, sampler))
            {
                if (camera.stereoEnabled) RecordEyes(cmd, camera, ViewsOf(renderingData.cameraData));
                Blitter.BlitCameraTexture(cmd, renderingData.cameraData.renderer.cameraColorTargetHandle, copy);
                WaterCameras.RecordBehind(cmd, camera, copy.rt.height);
                cmd.SetGlobalTexture(opaqueTexture, copy.nameID);
            }
            context.ExecuteCommandBuffer(cmd);
            CommandBufferPool.Release(cmd);
        }

        private static CameraViews ViewsOf(in CameraData data)
        {
            var left = new CameraViews(data.GetViewMatrix(), data.GetProjectionMatrix());
            return data.cameraTargetDescriptor.volumeDepth < 2 ? left
                : new CameraViews(left.View(0), left.Projection(0), data.GetViewMatrix(1), data.GetProjectionMatrix(1));
        }

        public void Release()
        {
            copy?.Release();
            copy = null;
        }
#pragma warning restore CS0618, CS0672
#else
        public void Release()
        {
        }
#endif

        private static bool IsNeeded(Camera camera) => camera.stereoEnabled || WaterCameras.SeesBehind(camera);

        // The eyes' matrices are known here alone. Those of the pass are put back.
        private static void RecordEyes(CommandBuffer cmd, Camera camera, in CameraViews views)
        {
            WaterCameras.RecordThickness(cmd, camera, views);
            cmd.SetViewProjectionMatrices(views.View(0), views.Projection(0));
        }

#if UNITY_6000_0_OR_NEWER
        public override void RecordRenderGraph(RenderGraph renderGraph, ContextContainer frameData)
        {
            var resources = frameData.Get<UniversalResourceData>();
            var cameraData = frameData.Get<UniversalCameraData>();
            Camera camera = cameraData.camera;
            if (!IsNeeded(camera) || !resources.cameraOpaqueTexture.IsValid()) return;
            using (IUnsafeRenderGraphBuilder builder = renderGraph.AddUnsafePass("Fluid Behind Water", out PassData data, sampler))
            {
                data.Camera = camera;
                data.Views = ViewsOf(cameraData);
                data.Colour = resources.cameraOpaqueTexture;
                data.Height = renderGraph.GetTextureDesc(data.Colour).height;
                builder.UseTexture(data.Colour, AccessFlags.ReadWrite);
                if (resources.cameraDepthTexture.IsValid()) builder.UseTexture(resources.cameraDepthTexture);
                if (resources.mainShadowsTexture.IsValid()) builder.UseTexture(resources.mainShadowsTexture);
                builder.AllowPassCulling(false);
                builder.AllowGlobalStateModification(true);
                builder.SetRenderFunc((PassData pass, UnsafeGraphContext context) => Draw(pass, context));
            }
        }

        private static void Draw(PassData data, UnsafeGraphContext context)
        {
            CommandBuffer cmd = CommandBufferHelpers.GetNativeCommandBuffer(context.cmd);
            if (data.Camera.stereoEnabled) RecordEyes(cmd, data.Camera, data.Views);
            context.cmd.SetRenderTarget(
                new RenderTargetIdentifier(data.Colour, 0, CubemapFace.Unknown, RenderTargetIdentifier.AllDepthSlices));
            WaterCameras.RecordBehind(cmd, data.Camera, data.Height);
        }

        private static CameraViews ViewsOf(UniversalCameraData data)
        {
            var left = new CameraViews(data.GetViewMatrix(), data.GetProjectionMatrix());
            return data.cameraTargetDescriptor.volumeDepth < 2 ? left
                : new CameraViews(left.View(0), left.Projection(0), data.GetViewMatrix(1), data.GetProjectionMatrix(1));
        }

        private sealed class PassData
        {
            public Camera Camera;
            public CameraViews Views;
            public TextureHandle Colour;
            public int Height;
        }
#endif
    }
}
