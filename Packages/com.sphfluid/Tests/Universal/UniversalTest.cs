using System.Collections;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;
using ShadowQuality = UnityEngine.ShadowQuality;

namespace SphFluid.Tests
{
    /// <summary>
    /// Draws a scene with water by the Built-in pipeline and by a copy of the project's Universal asset, at equal settings.
    /// </summary>
    public abstract class UniversalTest
    {
        // Both filters of shadows are a few texels wide: with as many texels a metre, edges are equally soft.
        private const float ShadowDistance = 4f;

        private PipelineSwitch pipeline;
        private (float Distance, int Cascades, int Lamps, ShadowQuality Shadows) quality;

        private protected WaterScene Scene { get; set; }

        /// <summary>A copy that the test may change.</summary>
        private protected UniversalRenderPipelineAsset Asset { get; private set; }

        private protected UniversalRendererData Renderer => AssetFields.RendererOf(Asset);

        /// <summary>What the Built-in pipeline drew last.</summary>
        private protected Picture BuiltIn { get; private set; }

        /// <summary>What the Universal Render Pipeline drew last.</summary>
        private protected Picture Universal { get; private set; }

        [SetUp]
        public void SetUp()
        {
            GpuTest.Require();
            if (QualitySettings.activeColorSpace != ColorSpace.Linear) Assert.Ignore("The pipelines agree in linear colours only.");
            quality = (QualitySettings.shadowDistance, QualitySettings.shadowCascades, QualitySettings.pixelLightCount,
                QualitySettings.shadows);
            Asset = AssetFields.Copy();
            Asset.shadowDistance = ShadowDistance;
            Asset.msaaSampleCount = 1;
            Cascades(1);
            pipeline = new PipelineSwitch(null);
            Scene = new WaterScene();
        }

        [TearDown]
        public void TearDown()
        {
            if (Asset == null) return;
            Scene.Dispose();
            pipeline.Dispose();
            AssetFields.Destroy(Asset);
            (QualitySettings.shadowDistance, QualitySettings.shadowCascades) = (quality.Distance, quality.Cascades);
            (QualitySettings.pixelLightCount, QualitySettings.shadows) = (quality.Lamps, quality.Shadows);
            Asset = null;
        }

        /// <summary>In both pipelines.</summary>
        private protected void Cascades(int count)
        {
            (QualitySettings.shadowDistance, QualitySettings.shadowCascades) = (ShadowDistance, count);
            QualitySettings.shadows = ShadowQuality.All;
            Asset.shadowCascadeCount = count;
        }

        private protected void Replace(params Bounds[] liquid)
        {
            Scene.Dispose();
            Scene = new WaterScene(liquid);
        }

        private protected IEnumerator DrawBoth()
        {
            yield return DrawBuiltIn();
            yield return DrawUniversal();
        }

        private protected IEnumerator DrawBuiltIn()
        {
            pipeline.To(null);
            yield return WaterScene.Frames();
            BuiltIn = Scene.Picture;
        }

        private protected IEnumerator DrawUniversal()
        {
            pipeline.To(Asset);
            yield return WaterScene.Frames();
            Universal = Scene.Picture;
        }

        /// <summary>The pictures of both pipelines look alike.</summary>
        private protected void AssertAlike(double least = 0.97) => AssertAlike(Universal, BuiltIn, least);

        private protected static void AssertAlike(Picture seen, Picture expected, double least = 0.97)
        {
            double similarity = StructuralSimilarity.Of(seen, expected);
            TestContext.WriteLine($"structural similarity {similarity:0.0000}");
            Assert.That(similarity, Is.GreaterThanOrEqualTo(least));
        }
    }
}
