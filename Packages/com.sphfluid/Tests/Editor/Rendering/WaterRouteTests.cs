using System.Reflection;
using NUnit.Framework;
using SphFluid.Editor;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>What the inspector says of each render pipeline.</summary>
    public sealed class WaterRouteTests
    {
        [TestCase(0, false, true, "copy of each camera's picture")]
        [TestCase(1, true, true, "opaque texture")]
        [TestCase(1, false, false, "Refraction is missing")]
        [TestCase(2, true, false, "Refraction, reflection probes and shadows are missing")]
        public void WhatIsMissingIsReportedForEachPipeline(int kind, bool hasUniversal, bool isComplete, string said)
        {
            WaterRoute route = WaterRoute.Choose((DrawPipelineKind)kind, hasUniversal ? new LimitedTextures(RendererLimit.None) : null);
            Assert.AreEqual(isComplete, route.IsComplete);
            StringAssert.Contains(said, route.Text);
        }

        [TestCase(1, "Universal Renderer in Tile-Only Mode", "turn Tile-Only Mode off")]
        [TestCase(2, "2D Renderer", "a Universal Renderer")]
        public void RendererWithoutAPictureOfTheSceneIsNamedWithTheCure(int limit, string named, string cure)
        {
            var textures = new LimitedTextures((RendererLimit)limit);
            WaterRoute route = WaterRoute.Choose(DrawPipelineKind.Universal, textures);
            Assert.IsFalse(route.IsComplete);
            StringAssert.StartsWith(named, route.Text);
            StringAssert.Contains(cure, route.Text);
            Assert.IsTrue(WaterRoute.Choose(DrawPipelineKind.BuiltIn, textures).IsComplete);
        }

        [TestCase(0)]
        [TestCase(1)]
        public void InspectorHidesFieldsThatExist(int look)
        {
            foreach (string field in FluidSurfaceRendererEditor.Hidden((FluidSurfaceLook)look))
            {
                if (field != "m_Script")
                {
                    Assert.IsNotNull(typeof(FluidSurfaceRenderer).GetField(field, BindingFlags.Instance | BindingFlags.NonPublic), field);
                }
            }
        }

        [Test]
        public void SourcesAreNumberedAsTheShaderReadsThem()
        {
            Assert.AreEqual(new Vector4(1f, 1f, 0f, 0f), new SceneTextures(SceneColourSource.Copy, true).ToVector());
            Assert.AreEqual(new Vector4(2f, 0f, 0f, 0f), new SceneTextures(SceneColourSource.OpaqueTexture, false).ToVector());
            Assert.AreEqual(Vector4.zero, default(SceneTextures).ToVector());
        }

        private sealed class LimitedTextures : ISceneTextureSource
        {
            public LimitedTextures(RendererLimit limit)
            {
                Limit = limit;
            }

            public RendererLimit Limit { get; }

            public SceneTextures Request(Camera camera) => default;

            public void Release()
            {
            }
        }
    }
}
