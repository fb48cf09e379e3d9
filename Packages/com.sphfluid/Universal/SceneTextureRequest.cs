using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;
#if UNITY_6000_0_OR_NEWER
using UnityEngine.Rendering.RenderGraphModule;
#endif

namespace SphFluid
{
    /// <summary>
    /// A pass that draws nothing: its inputs make the pipeline copy the opaque scene's colour and depth before transparent things are
    /// drawn.
    /// </summary>
    internal sealed class SceneTextureRequest : ScriptableRenderPass
    {
        public SceneTextureRequest()
        {
            renderPassEvent = RenderPassEvent.BeforeRenderingTransparents;
            ConfigureInput(ScriptableRenderPassInput.Color | ScriptableRenderPassInput.Depth);
        }

        // In 6000.3 without the render graph only where a project asks for it; from 6000.4 on never, whatever define is left over.
#if !UNITY_6000_3_OR_NEWER || (URP_COMPATIBILITY_MODE && !UNITY_6000_4_OR_NEWER)
#pragma warning disable CS0672 // the base is marked obsolete from 6000.0 on, and called all the same in compatibility mode
        public override void Execute(ScriptableRenderContext context, ref RenderingData renderingData)
        {
        }
#pragma warning restore CS0672
#endif

#if UNITY_6000_0_OR_NEWER
        public override void RecordRenderGraph(RenderGraph renderGraph, ContextContainer frameData)
        {
        }
#endif
    }
}
