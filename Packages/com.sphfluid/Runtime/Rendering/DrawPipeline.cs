using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Render pipelines that the drawings distinguish. The package references none of their assemblies.</summary>
    internal enum DrawPipelineKind
    {
        /// <summary>Built-in.</summary>
        BuiltIn,

        /// <summary>The Universal Render Pipeline or another scriptable one that sets Unity's own matrices.</summary>
        Universal,

        /// <summary>The High Definition Render Pipeline: camera-relative, exposed in the shader.</summary>
        HighDefinition,
    }

    /// <summary>Which render pipeline draws, and what the drawings do differently for it.</summary>
    internal static class DrawPipeline
    {
        private const string HighDefinitionAsset = "HDRenderPipelineAsset";
        private const string HighDefinitionKeyword = "FLUID_HDRP";

        /// <summary>The pipeline that draws now.</summary>
        public static DrawPipelineKind Active
        {
            get
            {
                RenderPipelineAsset asset = GraphicsSettings.currentRenderPipeline;
                return asset == null ? DrawPipelineKind.BuiltIn : Identify(asset.GetType().Name);
            }
        }

        /// <summary>The pipeline that an asset of this class belongs to.</summary>
        public static DrawPipelineKind Identify(string assetClass) =>
            assetClass == HighDefinitionAsset ? DrawPipelineKind.HighDefinition : DrawPipelineKind.Universal;

        /// <summary>
        /// Whether a liquid can cast and receive shadows. Not in HDRP: it hands the light's matrices to shadow passes in a constant buffer
        /// of its own.
        /// </summary>
        public static bool HasShadows(DrawPipelineKind kind) => kind != DrawPipelineKind.HighDefinition;

        /// <summary>Prepares a material that the package made.</summary>
        public static void Prepare(Material material, DrawPipelineKind kind) =>
            DrawMaterial.SetKeyword(material, HighDefinitionKeyword, kind == DrawPipelineKind.HighDefinition);

        /// <summary>Sets what shaders need to know of the pipeline: scriptable ones leave <c>unity_LightShadowBias</c> unset.</summary>
        public static void Apply(MaterialPropertyBlock properties, DrawPipelineKind kind) =>
            properties.SetFloat(RenderShaderIds.FluidShadowClamp, kind == DrawPipelineKind.BuiltIn ? 0f : 1f);

        /// <summary>Sets what shaders need to know of the pipeline and of the shadows that they cast and receive.</summary>
        public static void Apply(MaterialPropertyBlock properties, in DrawPlacement placement)
        {
            Apply(properties, placement.Pipeline);
            NoShadowMap.Bind();
            properties.SetVector(RenderShaderIds.FluidReceived,
                new Vector4(placement.ReceiveShadows ? 1f : 0f, placement.Spacing, placement.WaterShadow, 0f));
        }
    }
}
