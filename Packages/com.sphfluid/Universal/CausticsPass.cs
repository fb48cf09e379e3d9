using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;
#if UNITY_6000_0_OR_NEWER
using UnityEngine.Rendering.RenderGraphModule;
#endif

namespace SphFluid
{
    /// <summary>Draws caustics into the camera's picture once its opaque things are there, before the copy that water refracts.</summary>
    internal sealed class CausticsPass : ScriptableRenderPass
    {
        [OutlivesPlay("it is a name in the profiler")]
        private static readonly ProfilingSampler sampler = new ProfilingSampler("Fluid Caustics");

        public CausticsPass()
        {
            renderPassEvent = RenderPassEvent.BeforeRenderingSkybox;
            ConfigureInput(ScriptableRenderPassInput.Depth);
        }

        // In 6000.3 without the render graph only where a project asks for it; from 6000.4 on never, whatever define is left over.
#if !UNITY_6000_3_OR_NEWER || (URP_COMPATIBILITY_MODE && !UNITY_6000_4_OR_NEWER)
#pragma warning disable CS0618, CS0672 // marked obsolete from 6000.0 on, and called all the same in compatibility mode
        public override void Execute(ScriptableRenderContext context, ref RenderingData renderingData)
        {
            CommandBuffer cmd = CommandBufferPool.Get();
            using (new ProfilingScope(cmd, sampler)) WaterCaustics.Record(cmd, renderingData.cameraData.camera);
            context.ExecuteCommandBuffer(cmd);
            CommandBufferPool.Release(cmd);
        }
#pragma warning restore CS0618, CS0672
#endif

#if UNITY_6000_0_OR_NEWER
        public override void RecordRenderGraph(RenderGraph renderGraph, ContextContainer frameData)
        {
            var resources = frameData.Get<UniversalResourceData>();
            if (!resources.cameraDepthTexture.IsValid()) return;
            using (IUnsafeRenderGraphBuilder builder = renderGraph.AddUnsafePass("Fluid Caustics", out PassData data, sampler))
            {
                data.Camera = frameData.Get<UniversalCameraData>().camera;
                data.Colour = resources.activeColorTexture;
                builder.UseTexture(data.Colour, AccessFlags.ReadWrite);
                builder.UseTexture(resources.cameraDepthTexture);
                if (resources.mainShadowsTexture.IsValid()) builder.UseTexture(resources.mainShadowsTexture);
                builder.AllowPassCulling(false);
                builder.SetRenderFunc((PassData pass, UnsafeGraphContext context) => Draw(pass, context));
            }
        }

        private static void Draw(PassData data, UnsafeGraphContext context)
        {
            context.cmd.SetRenderTarget(
                new RenderTargetIdentifier(data.Colour, 0, CubemapFace.Unknown, RenderTargetIdentifier.AllDepthSlices));
            WaterCaustics.Record(CommandBufferHelpers.GetNativeCommandBuffer(context.cmd), data.Camera);
        }

        private sealed class PassData
        {
            public Camera Camera;
            public TextureHandle Colour;
        }
#endif
    }
}
