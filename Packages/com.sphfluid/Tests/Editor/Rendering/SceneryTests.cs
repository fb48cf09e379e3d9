using System.Collections.Generic;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid.Tests
{
    /// <summary>
    /// The samples' shader in the Built-in pipeline, against its formulas in double precision, its shadows and further lights.
    /// </summary>
    public sealed class SceneryTests
    {
        private const string ShaderPath = "Packages/com.sphfluid/Shaders/Rendering/Scenery.shader";
        private const int Size = 33;

        private readonly List<Object> made = new List<Object>();
        private readonly Color colour = new Color(0.8f, 0.5f, 0.3f);
        private PipelineSwitch pipeline;
        private AmbientMode ambientMode;
        private Color ambientLight;
        private Light sun;
        private Camera camera;
        private Light lamp;
        private Material material;
        private Renderer wall;

        [SetUp]
        public void SetUp()
        {
            GpuTest.Require();
            if (QualitySettings.activeColorSpace != ColorSpace.Linear) Assert.Ignore("The formulas are those of linear colours.");
            pipeline = PipelineSwitch.ToBuiltIn();
            (ambientMode, ambientLight, sun) = (RenderSettings.ambientMode, RenderSettings.ambientLight, RenderSettings.sun);
            RenderSettings.ambientMode = AmbientMode.Flat;
            RenderSettings.ambientLight = Color.black;
            material = Keep(new Material(AssetDatabase.LoadAssetAtPath<Shader>(ShaderPath)));
            material.SetColor("_Color", colour);
            wall = NewThing(PrimitiveType.Quad).GetComponent<Renderer>();
            wall.transform.localScale = Vector3.one * 2f;
            camera = Keep(new GameObject("Camera")).AddComponent<Camera>();
            camera.transform.position = new Vector3(0f, 0f, -2f);
            camera.orthographic = true;
            camera.orthographicSize = 0.5f;
            camera.clearFlags = CameraClearFlags.SolidColor;
            camera.backgroundColor = Color.black;
            camera.allowMSAA = false;
            camera.targetTexture = Keep(new RenderTexture(Size, Size, 24, RenderTextureFormat.ARGBFloat, RenderTextureReadWrite.Linear));
            lamp = Keep(new GameObject("Light")).AddComponent<Light>();
            lamp.type = LightType.Directional;
            RenderSettings.sun = lamp;
        }

        [TearDown]
        public void TearDown()
        {
            if (made.Count == 0) return;
            camera.targetTexture = null;
            for (int i = made.Count - 1; i >= 0; i--) Object.DestroyImmediate(made[i]);
            made.Clear();
            pipeline.Dispose();
            (RenderSettings.ambientMode, RenderSettings.ambientLight, RenderSettings.sun) = (ambientMode, ambientLight, sun);
        }

        [TestCase(0f, 0f, 0.3f, 1f)]
        [TestCase(40f, 0f, 0.3f, 1f)]
        [TestCase(70f, 10f, 0f, 0.5f)]
        [TestCase(20f, -15f, 0.9f, 2f)]
        [TestCase(180f, 0f, 0.5f, 1f)]
        public void TheMainLightIsReflectedByTheFormula(float pitch, float yaw, float smoothness, float intensity)
        {
            material.SetFloat("_Smoothness", smoothness);
            lamp.transform.rotation = Quaternion.Euler(pitch, yaw, 0f);
            lamp.intensity = intensity;
            Color seen = Centre();
            Vector4 light = SceneLighting.ColourOf(lamp);
            for (int c = 0; c < 3; c++)
            {
                double expected = Reflection(colour.linear[c], smoothness, -lamp.transform.forward) * light[c];
                Assert.AreEqual(expected, seen[c], 2e-3 + 0.01 * expected, $"channel {c}");
            }
        }

        [Test]
        public void TheAmbientLightIsReflectedByTheFormula()
        {
            lamp.enabled = false;
            RenderSettings.ambientLight = new Color(0.5f, 0.6f, 0.7f);
            material.SetFloat("_Smoothness", 0.25f);
            Color seen = Centre();
            for (int c = 0; c < 3; c++)
            {
                double ambient = RenderSettings.ambientLight.linear[c];
                Assert.AreEqual(ambient * (colour.linear[c] * 0.96 + 0.04 / (1.0 + 0.75 * 0.75)), seen[c], 2e-3, $"channel {c}");
            }
        }

        [Test]
        public void ShadowsAreCastAndReceived()
        {
            if (QualitySettings.shadows == ShadowQuality.Disable) Assert.Ignore("The quality level has no shadows.");
            Vector3 toLight = new Vector3(-0.6f, 0.6f, -0.53f).normalized;
            lamp.transform.rotation = Quaternion.LookRotation(-toLight);
            lamp.shadows = LightShadows.Soft;
            float lit = Centre().g;
            Renderer caster = NewThing(PrimitiveType.Cube).GetComponent<Renderer>();
            caster.transform.localScale = Vector3.one * 0.25f;
            caster.transform.position = toLight;
            Assert.AreEqual(0f, Centre().g, 0.02f * lit, "in the shadow");
            caster.shadowCastingMode = ShadowCastingMode.Off;
            Assert.AreEqual(lit, Centre().g, 0.02f * lit, "a thing that casts none");
            caster.shadowCastingMode = ShadowCastingMode.On;
            wall.receiveShadows = false;
            Assert.AreEqual(lit, Centre().g, 0.02f * lit, "a thing that receives none");
        }

        [Test]
        public void AFurtherDirectionalLightIsAdded()
        {
            Color main = Centre();
            Light second = NewLight(LightType.Directional, new Color(1f, 0.4f, 0.2f));
            second.transform.rotation = Quaternion.Euler(40f, 20f, 0f);
            Color seen = Centre();
            Vector4 light = SceneLighting.ColourOf(second);
            for (int c = 0; c < 3; c++)
            {
                double expected = Reflection(colour.linear[c], 0.3, -second.transform.forward) * light[c];
                Assert.AreEqual(expected, seen[c] - main[c], 2e-3 + 0.01 * expected, $"channel {c}");
            }
        }

        [TestCase(LightType.Point)]
        [TestCase(LightType.Spot)]
        public void APointOrSpotLightIsAddedWhereItReaches(LightType type)
        {
            Color main = Centre();
            Light near = NewLight(type, Color.white);
            near.transform.position = new Vector3(0f, 0f, -1f);
            (near.range, near.spotAngle) = (4f, 60f);
            double reflected = Reflection(colour.linear.g, 0.3, Vector3.back);
            double share = (Centre().g - main.g) / reflected;
            Assert.AreEqual(1.0 / (1.0 + 25.0 / 16.0), share, 0.05, "a quarter of the range away");

            near.range = 0.9f;
            Assert.AreEqual(main.g, Centre().g, 1e-3f, "beyond its range");

            near.range = 4f;
            near.transform.rotation = Quaternion.Euler(0f, 90f, 0f);
            if (type == LightType.Spot) Assert.AreEqual(main.g, Centre().g, 1e-3f, "outside its cone");
        }

        [Test]
        public void AnUnimportantPointLightIsAddedAtTheVertices()
        {
            Color main = Centre();
            Light near = NewLight(LightType.Point, Color.white);
            near.renderMode = LightRenderMode.ForceVertex;
            near.transform.position = new Vector3(0f, 0f, -1f);
            near.range = 10f;

            // The wall's corners, 1.73 m away, have light / (1 + 25 / 100 * 3) at a cosine of 0.58.
            double expected = colour.linear.g * 0.96 * 0.577 / 1.75;
            Assert.AreEqual(expected, Centre().g - main.g, 0.05 * expected);
        }

        // Pixels of a quarter of a tile. Squares and grout are averaged each for itself, so each is tested alone.
        [TestCase(true)]
        [TestCase(false)]
        public void TilesAreAveragedOverPixels(bool squares)
        {
            const double Pixel = 1.0 / Size, Tile = 4.0 * Pixel, Grout = 0.3 * Tile;
            if (squares) Tiles(Tile, 0.0, Color.black, Color.white, Color.red);
            else Tiles(Tile, Grout, Color.white, Color.white, Color.black);
            double[,] seen = Albedos();
            for (int row = 0; row < Size; row++)
            {
                for (int column = 0; column < Size; column++)
                {
                    double x = (column + 0.5) * Pixel - 0.5 + 0.013, y = (row + 0.5) * Pixel - 0.5 + 0.021;
                    double white = squares
                        ? 0.5 - 0.5 * Mean(x, Pixel, at => System.Math.Floor(at / Tile) % 2.0 == 0.0 ? 1.0 : -1.0)
                            * Mean(y, Pixel, at => System.Math.Floor(at / Tile) % 2.0 == 0.0 ? 1.0 : -1.0)
                        : Mean(x, Pixel, at => IsGrout(at, Tile, Grout) ? 0.0 : 1.0) *
                            Mean(y, Pixel, at => IsGrout(at, Tile, Grout) ? 0.0 : 1.0);
                    Assert.AreEqual(white, seen[column, row], 0.01, $"at {x:F3}, {y:F3}");
                }
            }
        }

        [Test]
        public void TilesSmallerThanPixelsAreTheirMean()
        {
            Tiles(0.003, 0.0006, Color.white, Color.black, Color.black);
            // A fifth of each axis is grout: 0.64 of the area is tiles, half of them white.
            foreach (double seen in Albedos()) Assert.AreEqual(0.32, seen, 0.005);
        }

        [Test]
        public void FarAwayItFadesToItsFadingColour()
        {
            lamp.enabled = false;
            material.SetColor("_FadeColor", new Color(0.2f, 0.4f, 0.9f));
            material.SetFloat("_FadeDistance", 4f);
            Color seen = Centre(), fading = new Color(0.2f, 0.4f, 0.9f).linear;
            for (int c = 0; c < 3; c++)
            {
                Assert.AreEqual((1.0 - System.Math.Exp(-0.25)) * fading[c], seen[c], 2e-3, "2 of 4 m away, itself black");
            }
            material.SetFloat("_FadeDistance", 0f);
            Assert.AreEqual(0f, Centre().b, 1e-4f);
        }

        private static bool IsGrout(double at, double tile, double grout) =>
            System.Math.Abs(at - tile * System.Math.Round(at / tile)) < 0.5 * grout;

        private static double Mean(double centre, double width, System.Func<double, double> value)
        {
            const int Samples = 400;
            double sum = 0.0;
            for (int i = 0; i < Samples; i++) sum += value(centre + width * ((i + 0.5) / Samples - 0.5));
            return sum / Samples;
        }

        // The wall in even white ambient light. The camera stands a little off a corner, so that no pixel lies on an edge by chance.
        private void Tiles(double edge, double grout, Color first, Color second, Color between)
        {
            lamp.enabled = false;
            RenderSettings.ambientLight = Color.white;
            camera.transform.position = new Vector3(0.013f, 0.021f, -2f);
            (string, Color)[] colours = { ("_Color", first), ("_TileColor", second), ("_GroutColor", between) };
            foreach ((string name, Color value) in colours) material.SetColor(name, value);
            material.SetFloat("_TileSize", (float)edge);
            material.SetFloat("_Grout", (float)grout);
            material.SetFloat("_Smoothness", 0f);
        }

        // What is left of white ambient light without the share that is mirrored.
        private double[,] Albedos()
        {
            var albedos = new double[Size, Size];
            Texture2D picture = Picture();
            for (int row = 0; row < Size; row++)
                for (int column = 0; column < Size; column++) albedos[column, row] = (picture.GetPixel(column, row).g - 0.02) / 0.96;
            Object.DestroyImmediate(picture);
            return albedos;
        }

        private Light NewLight(LightType type, Color light)
        {
            Light added = Keep(new GameObject("Further light")).AddComponent<Light>();
            (added.type, added.color, added.renderMode, added.shadows) = (type, light, LightRenderMode.ForcePixel, LightShadows.None);
            return added;
        }

        // Seen straight on: normal and view are the same. Pi is left out, as in Unity's light colours.
        private static double Reflection(double albedo, double smoothness, Vector3 light)
        {
            Vector3 normal = Vector3.back;
            double lit = System.Math.Max(0.0, Vector3.Dot(normal, light));
            Vector3 between = (light + normal).normalized;
            double facing = System.Math.Max(0.0, Vector3.Dot(normal, between)),
                grazing = 1.0 - System.Math.Max(0.0, Vector3.Dot(light, between));
            double roughness = System.Math.Max((1.0 - smoothness) * (1.0 - smoothness), 0.002), squared = roughness * roughness;
            double distribution = squared / System.Math.Pow(facing * facing * (squared - 1.0) + 1.0, 2.0);
            double visibility = 0.5 / (lit + lit * (1.0 - roughness) + roughness);
            double fresnel = 0.04 + 0.96 * System.Math.Pow(grazing, 5.0);
            return (albedo * 0.96 + fresnel * distribution * visibility) * lit;
        }

        private Color Centre()
        {
            Texture2D picture = Picture();
            Color seen = picture.GetPixel(Size / 2, Size / 2);
            Object.DestroyImmediate(picture);
            return seen;
        }

        private Texture2D Picture()
        {
            camera.Render();
            RenderTexture before = RenderTexture.active;
            var picture = new Texture2D(Size, Size, TextureFormat.RGBAFloat, false, true);
            RenderTexture.active = camera.targetTexture;
            picture.ReadPixels(new Rect(0, 0, Size, Size), 0, 0);
            picture.Apply();
            RenderTexture.active = before;
            return picture;
        }

        private GameObject NewThing(PrimitiveType type)
        {
            GameObject thing = Keep(GameObject.CreatePrimitive(type));
            thing.GetComponent<Renderer>().sharedMaterial = material;
            return thing;
        }

        private T Keep<T>(T thing) where T : Object
        {
            made.Add(thing);
            return thing;
        }
    }
}
