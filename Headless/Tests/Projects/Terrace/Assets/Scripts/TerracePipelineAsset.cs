using UnityEngine;
using UnityEngine.Rendering;

namespace Terrace
{
    [CreateAssetMenu(menuName = "Terrace/Pipeline")]
    public sealed class TerracePipelineAsset : RenderPipelineAsset
    {
        public int shadowResolution = 512;
        public float shadowDistance = 30f;

        public override string renderPipelineShaderTag => "TerracePipeline";

        protected override RenderPipeline CreatePipeline() => new TerracePipeline(this);
    }
}
