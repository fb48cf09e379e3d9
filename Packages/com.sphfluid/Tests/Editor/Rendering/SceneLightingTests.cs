using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid.Tests
{
    /// <summary>Which light reaches the property block of a drawing.</summary>
    public sealed class SceneLightingTests
    {
        private readonly List<GameObject> made = new List<GameObject>();
        private bool linearIntensity;
        private Light sun;
        private AmbientMode ambientMode;
        private Color ambientLight;

        [SetUp]
        public void SetUp()
        {
            linearIntensity = GraphicsSettings.lightsUseLinearIntensity;
            sun = RenderSettings.sun;
            ambientMode = RenderSettings.ambientMode;
            ambientLight = RenderSettings.ambientLight;
            RenderSettings.sun = null;
        }

        [TearDown]
        public void TearDown()
        {
            foreach (GameObject holder in made) Object.DestroyImmediate(holder);
            made.Clear();
            GraphicsSettings.lightsUseLinearIntensity = linearIntensity;
            RenderSettings.sun = sun;
            RenderSettings.ambientMode = ambientMode;
            RenderSettings.ambientLight = ambientLight;
        }

        [Test]
        public void BrightestDirectionalLightIsTheMainLight()
        {
            NewLight(LightType.Directional, 10f, Quaternion.Euler(90f, 0f, 0f));
            Light brightest = NewLight(LightType.Directional, 20f, Quaternion.Euler(0f, 90f, 0f));
            NewLight(LightType.Point, 100f, Quaternion.identity);

            MaterialPropertyBlock properties = Apply();
            Assert.Less(Vector3.Distance(new Vector3(-1f, 0f, 0f), properties.GetVector("_FluidLightDirection")), 1e-5f,
                "against the light's forward axis");
            Assert.AreEqual(SceneLighting.ColourOf(brightest), properties.GetVector("_FluidLightColour"));

            brightest.enabled = false;
            Assert.Less(Vector3.Distance(Vector3.up, Apply().GetVector("_FluidLightDirection")), 1e-5f, "the next one");
        }

        [Test]
        public void OfEquallyBrightLightsTheFirstInTheHierarchyCounts()
        {
            NewLight(LightType.Directional, 20f, Quaternion.Euler(90f, 0f, 0f));
            Light later = NewLight(LightType.Directional, 20f, Quaternion.Euler(0f, 90f, 0f));
            Assert.Less(Vector3.Distance(Vector3.up, Apply().GetVector("_FluidLightDirection")), 1e-5f);

            later.transform.SetAsFirstSibling();
            Assert.Less(Vector3.Distance(Vector3.left, Apply().GetVector("_FluidLightDirection")), 1e-5f, "whichever was made first");
        }

        [Test]
        public void SunOfTheLightingSettingsComesFirst()
        {
            NewLight(LightType.Directional, 20f, Quaternion.identity);
            RenderSettings.sun = NewLight(LightType.Directional, 10f, Quaternion.Euler(90f, 0f, 0f));
            Assert.Less(Vector3.Distance(Vector3.up, Apply().GetVector("_FluidLightDirection")), 1e-5f);

            RenderSettings.sun.enabled = false;
            Assert.Less(Vector3.Distance(Vector3.back, Apply().GetVector("_FluidLightDirection")), 1e-5f,
                "a sun that is off does not count");
        }

        [Test]
        public void SwitchedOffLightIsNoticedAtOnce()
        {
            var lighting = new SceneLighting();
            var properties = new MaterialPropertyBlock();
            Light light = NewLight(LightType.Directional, 20f, Quaternion.identity);
            lighting.Apply(properties);
            Assert.AreEqual(SceneLighting.ColourOf(light), properties.GetVector("_FluidLightColour"));
            light.gameObject.SetActive(false);
            lighting.Apply(properties);
            Assert.AreNotEqual(SceneLighting.ColourOf(light), properties.GetVector("_FluidLightColour"));
        }

        [TestCase(false, 0.21404114f)]
        [TestCase(true, 0.5f)]
        public void IntensityFollowsThePipeline(bool linear, float expected)
        {
            if (QualitySettings.activeColorSpace != ColorSpace.Linear)
            {
                Assert.Ignore("The project is in gamma colour space, where the intensity is a plain factor.");
            }
            GraphicsSettings.lightsUseLinearIntensity = linear;
            Light light = NewLight(LightType.Directional, 0.5f, Quaternion.identity);
            light.color = Color.white;
            Assert.AreEqual(expected, SceneLighting.ColourOf(light).x, 1e-3f);
        }

        [Test]
        public void AmbientLightReachesTheBlock()
        {
            RenderSettings.ambientMode = AmbientMode.Flat;
            RenderSettings.ambientLight = new Color(0.8f, 0.5f, 0.2f);
            Vector4[] ambient = Apply().GetVectorArray("_FluidAmbient");
            SphericalHarmonicsL2 probe = RenderSettings.ambientProbe;
            Assert.AreEqual(7, ambient.Length);
            for (int c = 0; c < 3; c++) Assert.AreEqual(probe[c, 0] - probe[c, 6], ambient[c].w, 1e-6f);
        }

        // As Unity 6 leaves it where the scene has no lighting data.
        [Test]
        public void ABlackSkyYieldsToTheColoursOfTheLightingSettings()
        {
            RenderSettings.ambientMode = AmbientMode.Skybox;
            SphericalHarmonicsL2 probe = SceneLighting.Lit(default);
            Color sky = RenderSettings.ambientSkyColor.linear, ground = RenderSettings.ambientGroundColor.linear;
            for (int c = 0; c < 3; c++)
            {
                Assert.Greater(probe[c, 0], 0f);
                Assert.AreEqual(sky[c] - ground[c], (probe[c, 0] + probe[c, 1]) - (probe[c, 0] - probe[c, 1]), 1e-6f, "above less below");
            }
            var lit = new SphericalHarmonicsL2();
            lit[1, 0] = 0.5f;
            Assert.AreEqual(lit, SceneLighting.Lit(lit), "light that is there stays");
        }

        [Test]
        public void DarknessThatIsMeantStaysDark()
        {
            RenderSettings.ambientMode = AmbientMode.Flat;
            Assert.AreEqual(default(SphericalHarmonicsL2), SceneLighting.Lit(default));
            RenderSettings.ambientMode = AmbientMode.Skybox;
            float intensity = RenderSettings.ambientIntensity;
            RenderSettings.ambientIntensity = 0f;
            Assert.AreEqual(default(SphericalHarmonicsL2), SceneLighting.Lit(default));
            RenderSettings.ambientIntensity = intensity;
        }

        // Each coefficient its own number: where it goes, and that the sixth counts threefold.
        [Test]
        public void CoefficientsArePackedAsUnitysShadersReadThem()
        {
            var probe = new SphericalHarmonicsL2();
            for (int c = 0; c < 3; c++)
            {
                for (int i = 0; i < 9; i++) probe[c, i] = 10f * c + i;
            }
            var packed = new Vector4[7];
            SceneLighting.Pack(probe, packed);
            Assert.AreEqual(new Vector4(3f, 1f, 2f, -6f), packed[0]);
            Assert.AreEqual(new Vector4(23f, 21f, 22f, -6f), packed[2]);
            Assert.AreEqual(new Vector4(14f, 15f, 48f, 17f), packed[4]);
            Assert.AreEqual(new Vector4(8f, 18f, 28f, 1f), packed[6]);
        }

        private static MaterialPropertyBlock Apply()
        {
            var properties = new MaterialPropertyBlock();
            new SceneLighting().Apply(properties);
            return properties;
        }

        private Light NewLight(LightType type, float intensity, Quaternion rotation)
        {
            var holder = new GameObject("Light");
            made.Add(holder);
            holder.transform.rotation = rotation;
            Light light = holder.AddComponent<Light>();
            light.type = type;
            light.intensity = intensity;
            return light;
        }
    }
}
