using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid.Tests
{
    /// <summary>Lets another render pipeline draw than the project's, until it is disposed.</summary>
    public sealed class PipelineSwitch : IDisposable
    {
        private readonly RenderPipelineAsset ofProject = GraphicsSettings.defaultRenderPipeline;
        private readonly RenderPipelineAsset ofLevel = QualitySettings.renderPipeline;

        /// <param name="asset">Of the pipeline; null: Built-in.</param>
        public PipelineSwitch(RenderPipelineAsset asset) => To(asset);

        /// <summary>For tests of what the package does in Built-in alone.</summary>
        public static PipelineSwitch ToBuiltIn() => new PipelineSwitch(null);

        /// <param name="asset">Of the pipeline; null: Built-in.</param>
        public void To(RenderPipelineAsset asset) => Set(asset, asset);

        public void Dispose() => Set(ofProject, ofLevel);

        private static void Set(RenderPipelineAsset project, RenderPipelineAsset level)
        {
            GraphicsSettings.defaultRenderPipeline = project;
            QualitySettings.renderPipeline = level;
        }
    }
}
