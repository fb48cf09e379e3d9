using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid.Tests
{
    /// <summary>Which reflection map reaches the property block of a drawing.</summary>
    public sealed class SceneReflectionTests
    {
        private static readonly Bounds Liquid = new Bounds(new Vector3(1f, 0f, 0f), Vector3.one);

        private GameObject holder;
        private Cubemap map;
        private Cubemap other;

        [SetUp]
        public void SetUp()
        {
            holder = new GameObject("Probes");
            map = new Cubemap(4, TextureFormat.RGBA32, false);
            other = new Cubemap(4, TextureFormat.RGBA32, false);
        }

        [TearDown]
        public void TearDown()
        {
            Object.DestroyImmediate(holder);
            Object.DestroyImmediate(map);
            Object.DestroyImmediate(other);
        }

        [Test]
        public void ProbeAroundTheLiquidIsTaken()
        {
            NewProbe(other, new Vector3(5f, 0f, 0f), 2f, 0);
            ReflectionProbe near = NewProbe(map, Vector3.zero, 4f, 0);
            near.intensity = 0.5f;
            MaterialPropertyBlock properties = Apply(1f);
            Assert.AreSame(map, properties.GetTexture("_FluidReflectionMap"));
            Assert.AreEqual(1f, properties.GetVector("_FluidReflection").x);
            Assert.AreEqual(near.textureHDRDecodeValues, properties.GetVector("_FluidReflectionDecode"));
        }

        [Test]
        public void ImportanceComesBeforeSize()
        {
            NewProbe(other, Vector3.zero, 4f, 0);
            ReflectionProbe large = NewProbe(map, Vector3.zero, 8f, 1);
            Assert.AreSame(map, Apply(1f).GetTexture("_FluidReflectionMap"), "the more important");
            large.importance = 0;
            Assert.AreSame(other, Apply(1f).GetTexture("_FluidReflectionMap"), "the smaller");
        }

        [Test]
        public void OfEqualProbesTheFirstInTheHierarchyIsTaken()
        {
            NewProbe(map, Vector3.zero, 4f, 0);
            ReflectionProbe later = NewProbe(other, Vector3.zero, 4f, 0);
            Assert.AreSame(map, Apply(1f).GetTexture("_FluidReflectionMap"));
            later.transform.SetAsFirstSibling();
            Assert.AreSame(other, Apply(1f).GetTexture("_FluidReflectionMap"), "whichever was made first");
        }

        [Test]
        public void SkyIsTakenWhereNoProbeIs()
        {
            NewProbe(other, new Vector3(5f, 0f, 0f), 2f, 0);
            MaterialPropertyBlock properties = Apply(1f);
            bool hasSky = ReflectionProbe.defaultTexture != null && ReflectionProbe.defaultTexture.dimension == TextureDimension.Cube;
            Assert.AreEqual(hasSky ? 1f : 0f, properties.GetVector("_FluidReflection").x);
            if (hasSky) Assert.AreSame(ReflectionProbe.defaultTexture, properties.GetTexture("_FluidReflectionMap"));
        }

        // Its map is black where it was never baked; the shader then takes the ambient light.
        [Test]
        public void OnlyTheSkysMapMayBeUnbaked()
        {
            DefaultReflectionMode mode = RenderSettings.defaultReflectionMode;
            Texture custom = RenderSettings.customReflectionTexture;
            try
            {
                RenderSettings.defaultReflectionMode = DefaultReflectionMode.Skybox;
                Assert.AreEqual(1f, Apply(1f).GetVector("_FluidReflection").z);
                RenderSettings.defaultReflectionMode = DefaultReflectionMode.Custom;
                RenderSettings.customReflectionTexture = map;
                Assert.AreEqual(0f, Apply(1f).GetVector("_FluidReflection").z, "a black map of the user's is meant");
                RenderSettings.defaultReflectionMode = DefaultReflectionMode.Skybox;
                NewProbe(map, Vector3.zero, 4f, 0);
                Assert.AreEqual(0f, Apply(1f).GetVector("_FluidReflection").z, "so is a probe's");
            }
            finally
            {
                RenderSettings.defaultReflectionMode = mode;
                RenderSettings.customReflectionTexture = custom;
            }
        }

        [Test]
        public void ProbeThatIsSwitchedOffYieldsAtOnce()
        {
            ReflectionProbe near = NewProbe(map, Vector3.zero, 4f, 0);
            var reflection = new SceneReflection();
            var properties = new MaterialPropertyBlock();
            reflection.Apply(properties, Liquid, 1f);
            Assert.AreSame(map, properties.GetTexture("_FluidReflectionMap"));
            near.enabled = false;
            reflection.Apply(properties, Liquid, 1f);
            Assert.AreNotSame(map, properties.GetTexture("_FluidReflectionMap"));
        }

        [TestCase(1f, 0f)]
        [TestCase(0.9f, 0.978f)]
        [TestCase(0f, 6f)]
        public void RoughWaterTakesBlurredLevels(float smoothness, float level)
        {
            NewProbe(map, Vector3.zero, 4f, 0);
            Assert.AreEqual(level, Apply(smoothness).GetVector("_FluidReflection").y, 1e-3f);
        }

        private static MaterialPropertyBlock Apply(float smoothness)
        {
            var properties = new MaterialPropertyBlock();
            new SceneReflection().Apply(properties, Liquid, smoothness);
            return properties;
        }

        private ReflectionProbe NewProbe(Cubemap shown, Vector3 position, float size, int importance)
        {
            var made = new GameObject("Probe");
            made.transform.SetParent(holder.transform);
            made.transform.position = position;
            ReflectionProbe probe = made.AddComponent<ReflectionProbe>();
            probe.mode = ReflectionProbeMode.Custom;
            probe.customBakedTexture = shown;
            probe.size = Vector3.one * size;
            probe.importance = importance;
            return probe;
        }
    }
}
