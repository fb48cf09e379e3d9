using System.Collections.Generic;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>The samples' sky as the scene's skybox in the Built-in pipeline, direction by direction against its formulas.</summary>
    public sealed class SkyTests
    {
        private const string ShaderPath = "Packages/com.sphfluid/Shaders/Rendering/Sky.shader";
        private const int Size = 33;

        private readonly List<Object> made = new List<Object>();
        private readonly Vector3 toSun = new Vector3(0.48f, 0.6f, 0.64f);
        private PipelineSwitch pipeline;
        private Material skybox, material;
        private Light sun;
        private Camera camera;

        [SetUp]
        public void SetUp()
        {
            GpuTest.Require();
            if (QualitySettings.activeColorSpace != ColorSpace.Linear) Assert.Ignore("The formulas are those of linear colours.");
            pipeline = PipelineSwitch.ToBuiltIn();
            (skybox, sun) = (RenderSettings.skybox, RenderSettings.sun);
            material = Keep(new Material(AssetDatabase.LoadAssetAtPath<Shader>(ShaderPath)));
            material.SetFloat("_CloudCover", 0f);
            RenderSettings.skybox = material;
            Light light = Keep(new GameObject("Sun")).AddComponent<Light>();
            light.type = LightType.Directional;
            light.transform.rotation = Quaternion.LookRotation(-toSun);
            RenderSettings.sun = light;
            camera = Keep(new GameObject("Camera")).AddComponent<Camera>();
            camera.clearFlags = CameraClearFlags.Skybox;
            camera.cullingMask = 0;
            camera.fieldOfView = 1f;
            camera.allowMSAA = false;
            camera.transform.position = new Vector3(30f, 2f, -7f);
            camera.targetTexture = Keep(new RenderTexture(Size, Size, 24, RenderTextureFormat.ARGBFloat, RenderTextureReadWrite.Linear));
        }

        [TearDown]
        public void TearDown()
        {
            if (made.Count == 0) return;
            camera.targetTexture = null;
            for (int i = made.Count - 1; i >= 0; i--) Object.DestroyImmediate(made[i]);
            made.Clear();
            pipeline.Dispose();
            (RenderSettings.skybox, RenderSettings.sun) = (skybox, sun);
        }

        // Away from the sun, whose glow is 0 more than 90 degrees from it.
        [TestCase(90f)]
        [TestCase(30f)]
        [TestCase(3f)]
        [TestCase(-2f)]
        [TestCase(-60f)]
        public void TheAirGrowsHazierTowardsTheHorizon(float elevation)
        {
            material.SetFloat("_Glow", 0f);
            double up = System.Math.Sin(elevation * Mathf.Deg2Rad);
            Color horizon = material.GetColor("_Horizon").linear, far = material.GetColor(up > 0.0 ? "_Zenith" : "_Ground").linear;
            double haze = System.Math.Pow(2.0, up > 0.0 ? -6.0 * up : 9.0 * up);
            Color seen = Seen(Quaternion.Euler(-elevation, 217f, 0f) * Vector3.forward);
            for (int c = 0; c < 3; c++) Assert.AreEqual(far[c] + haze * (horizon[c] - far[c]), seen[c], 2e-3, $"channel {c}");
        }

        [Test]
        public void TheSunStandsWhereTheLightComesFrom()
        {
            material.SetFloat("_Glow", 0f);
            material.SetFloat("_SunRadius", 2f);
            Vector3 side = Vector3.Cross(toSun, Vector3.up).normalized;
            double disc = material.GetFloat("_SunLight") * material.GetColor("_Sun").linear.g;
            float air = Seen(Quaternion.AngleAxis(5f, side) * toSun).g;
            Assert.AreEqual(disc, Seen(toSun).g - air, 0.05 * disc);
            Assert.AreEqual(disc, Seen(Quaternion.AngleAxis(1.4f, side) * toSun).g - air, 0.05 * disc);
            Assert.AreEqual(air, Seen(Quaternion.AngleAxis(2.6f, side) * toSun).g, 0.05 * disc, "outside the disc");
            RenderSettings.sun.transform.rotation = Quaternion.LookRotation(Vector3.down);
            Assert.Less(Seen(toSun).g, air + 0.05 * disc, "the light turned away");
        }

        [Test]
        public void TheGlowFallsOffAroundTheSunAndTowardsTheHorizon()
        {
            float last = float.PositiveInfinity;
            foreach (float angle in new[] { 2f, 5f, 12f, 30f, 60f })
            {
                Vector3 direction = Quaternion.AngleAxis(angle, Vector3.Cross(toSun, Vector3.up)) * toSun;
                float glow = Glow(direction);
                Assert.Less(glow, last, $"{angle} degrees from the sun");
                last = glow;
            }
            Assert.AreEqual(0f, Glow(new Vector3(0.6f, 0.0005f, 0.8f)), 1e-3f, "at the horizon, as what fades there has its colour");
        }

        [Test]
        public void CloudsCoverAsMuchAsIsAsked()
        {
            material.SetFloat("_Glow", 0f);
            material.SetFloat("_SunLight", 0f);
            material.SetColor("_Cloud", Color.red);
            material.SetColor("_CloudShade", Color.red);
            material.SetColor("_Zenith", Color.blue);
            material.SetColor("_Horizon", Color.blue);
            camera.fieldOfView = 100f;
            float last = 0f;
            foreach (float cover in new[] { 0f, 0.3f, 0.6f, 1f })
            {
                material.SetFloat("_CloudCover", cover);
                float clouds = 0f;
                foreach (Color seen in Picture(Vector3.up)) clouds += seen.r / (Size * Size);
                if (cover == 0f) Assert.AreEqual(0f, clouds);
                else Assert.Greater(clouds, last + 0.05f, $"{cover}");
                last = clouds;
            }
            Assert.Greater(last, 0.99f);
        }

        private float Glow(Vector3 direction)
        {
            material.SetFloat("_Glow", 1f);
            float with = Seen(direction).g;
            material.SetFloat("_Glow", 0f);
            return with - Seen(direction).g;
        }

        private Color Seen(Vector3 direction) => Picture(direction)[Size * Size / 2];

        private Color[] Picture(Vector3 direction)
        {
            camera.transform.rotation = Quaternion.LookRotation(direction);
            camera.Render();
            RenderTexture before = RenderTexture.active;
            var picture = new Texture2D(Size, Size, TextureFormat.RGBAFloat, false, true);
            RenderTexture.active = camera.targetTexture;
            picture.ReadPixels(new Rect(0, 0, Size, Size), 0, 0);
            picture.Apply();
            RenderTexture.active = before;
            Color[] pixels = picture.GetPixels();
            Object.DestroyImmediate(picture);
            return pixels;
        }

        private T Keep<T>(T thing) where T : Object
        {
            made.Add(thing);
            return thing;
        }
    }
}
