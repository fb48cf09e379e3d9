using System;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;
using Object = UnityEngine.Object;

namespace SphFluid.Tests
{
    /// <summary>Colours of water before a background of known colours, against the formulas they come from.</summary>
    public sealed class WaterShadingTests
    {
        private const int Size = WaterRig.Size;
        private const float Reflectance = 0.02f;

        private WaterRig rig;
        private Cubemap mirror;

        [SetUp]
        public void SetUp() => rig = new WaterRig();

        [TearDown]
        public void TearDown()
        {
            rig.Dispose();
            if (mirror != null) Object.DestroyImmediate(mirror);
        }

        // 0.4 m of water straight on: exp(-extinction x 0.4 m) of 98 % of the background, no other light.
        [Test]
        public void BackgroundFadesByBeersLaw()
        {
            rig.Box(0.4f);
            Color pixel = WaterRig.Centre(rig.Render());
            for (int c = 0; c < 3; c++)
            {
                Assert.AreEqual(rig.Scene.GetPixel(0, 0)[c] * Mathf.Exp(-0.4f * rig.Look.Extinction[c]) * (1f - Reflectance), pixel[c],
                    2e-3f, $"channel {c}");
            }
            Assert.AreEqual(1f, pixel.a, 1e-4f);
        }

        // The bottom lies 0.1 m behind the front: only that much water counts. Depth is reversed on the device of Direct3D.
        [Test]
        public void WaterEndsAtTheSceneBehindIt()
        {
            rig.Box(0.4f);
            rig.SetDepth((x, y) => WaterRig.Distance - 0.2f + 0.1f);
            Color pixel = WaterRig.Centre(rig.Render());
            for (int c = 0; c < 3; c++)
            {
                Assert.AreEqual(rig.Scene.GetPixel(0, 0)[c] * Mathf.Exp(-0.1f * rig.Look.Extinction[c]) * (1f - Reflectance), pixel[c],
                    2e-3f, $"channel {c}");
            }
        }

        [Test]
        public void ScatteredLightFillsDeepWater()
        {
            rig.Box(0.4f);
            rig.ReplaceScene((x, y) => Color.black);
            Color pixel = WaterRig.Centre(rig.Render(block => block.SetVector("_FluidLightColour", Vector4.one)));
            for (int c = 0; c < 3; c++)
            {
                float share = rig.Look.Albedo[c] * (1f - Mathf.Exp(-0.4f * rig.Look.Extinction[c]));
                Assert.AreEqual(0.5f * share * (1f - Reflectance), pixel[c], 2e-3f, $"channel {c}");
            }
        }

        // Of a steep surface all, of a flat one what its skin lets out: of the weaker green still less. Clear liquid has no skin.
        [TestCase(0.05f, 0f)]
        [TestCase(0.05f, 0.8f)]
        [TestCase(1f, 0.8f)]
        public void ItsOwnLightComesThroughASkin(float visibility, float up)
        {
            rig.ReplaceScene((x, y) => Color.black);
            rig.Look.Visibility = visibility;
            rig.Look.ColorAtOneMetre = Color.black;
            rig.Look.AbsorptionDistance = 0.1f;
            rig.Look.Emission = new Color(1f, 0.5f, 0f);
            float towards = Mathf.Sqrt(1f - up * up);
            rig.Slope(new Vector3(0f, up, -towards));
            Color pixel = WaterRig.Centre(rig.Render());
            float open = 1f - 0.95f * rig.Look.Matt * up;
            float enters = (1f - Reflectance) * (1f - Mathf.Pow(1f - towards, 5f));
            Vector4 given = rig.Look.Surface;
            Assert.AreEqual(given.x * open * enters, pixel.r, 0.01f);
            Assert.AreEqual(given.y * open * Mathf.Lerp(open, 1f, given.y / given.x) * enters, pixel.g, 0.01f);
        }

        [Test]
        public void MirrorGrowsFromTwoPercentToAll()
        {
            rig.ReplaceScene((x, y) => Color.black);
            rig.Look.Visibility = 1e6f;
            rig.Box(0.4f);
            Assert.AreEqual(Reflectance, WaterRig.Centre(rig.Render(AmbientOfOne)).g, 2e-3f, "straight on");
            rig.Slope(new Vector3(1f, 0f, -1e-4f));
            Assert.AreEqual(1f, WaterRig.Centre(rig.Render(AmbientOfOne)).g, 0.01f, "grazing");
        }

        [Test]
        public void ReflectionMapIsMirroredWhereItIsGiven()
        {
            rig.ReplaceScene((x, y) => Color.black);
            rig.Look.Visibility = 1e6f;
            mirror = NewCube(CubemapFace.NegativeZ, Color.red);
            rig.Box(0.4f);
            Color pixel = WaterRig.Centre(rig.Render(block =>
            {
                block.SetTexture("_FluidReflectionMap", mirror);
                block.SetVector("_FluidReflection", new Vector4(1f, 0f, 0f, 0f));
                block.SetVector("_FluidReflectionDecode", new Vector4(2f, 1f, 0f, 0f));
            }));
            Assert.AreEqual(2f * Reflectance, pixel.r, 2e-3f, "what lies behind the camera");
            Assert.AreEqual(0f, pixel.g, 1e-3f);
        }

        // As Unity 6 hands it over where the scene has no lighting data; a black map of the user's is mirrored as it is.
        [TestCase(1f, Reflectance)]
        [TestCase(0f, 0f)]
        public void AMapThatWasNeverBakedYieldsToTheAmbientLight(float mayBeUnbaked, float expected)
        {
            rig.ReplaceScene((x, y) => Color.black);
            rig.Look.Visibility = 1e6f;
            mirror = NewCube(CubemapFace.NegativeZ, Color.black);
            rig.Box(0.4f);
            Color pixel = WaterRig.Centre(rig.Render(block =>
            {
                AmbientOfOne(block);
                block.SetTexture("_FluidReflectionMap", mirror);
                block.SetVector("_FluidReflection", new Vector4(1f, 0f, mayBeUnbaked, 0f));
                block.SetVector("_FluidReflectionDecode", new Vector4(1f, 1f, 0f, 0f));
            }));
            Assert.AreEqual(expected, pixel.g, 2e-3f);
        }

        // Without the scene's colour the water is blended over it: what it lets through is left to the blending.
        [Test]
        public void WithoutTheSceneWaterIsBlended()
        {
            rig.Box(0.4f);
            Color pixel = WaterRig.Centre(rig.Render(block => block.SetVector("_FluidScene", Vector4.zero)));
            float left = 0f;
            for (int c = 0; c < 3; c++) left += Mathf.Exp(-0.4f * rig.Look.Extinction[c]) / 3f;
            Assert.AreEqual(1f - left * (1f - Reflectance), pixel.a, 2e-3f);
        }

        // A surface without its wall faces: the water reaches to the domain's wall.
        [Test]
        public void OpenSurfaceEndsAtTheDomain()
        {
            rig.Surface = new UploadedSurface().Quad(new Vector3(0f, 0f, -0.2f), Vector3.up * 2f, Vector3.right * 2f, Vector3.back);
            Color pixel = WaterRig.Centre(rig.Render());
            Assert.AreEqual(rig.Scene.GetPixel(0, 0).r * Mathf.Exp(-2.2f * rig.Look.Extinction.x) * (1f - Reflectance), pixel.r, 4e-3f);
        }

        [TestCase(0f, 0)]
        [TestCase(0.25f, 2)]
        [TestCase(0.5f, 5)]
        [TestCase(1f, 9)]
        public void ShadowCoversItsShareOfTheTexels(float strength, int ofNine)
        {
            rig.Box(0.4f);
            rig.Look.Shadow = strength;
            int covered = 0;
            Color[] picture = rig.Render(null, WaterRig.ShadowPass, Color.white);
            for (int y = 0; y < 9; y++)
            {
                for (int x = 0; x < 9; x++) covered += picture[y * Size + x].r < 0.5f ? 1 : 0;
            }
            Assert.AreEqual(9 * ofNine, covered);
        }

        private static void AmbientOfOne(MaterialPropertyBlock block)
        {
            var ambient = new Vector4[7];
            for (int c = 0; c < 3; c++) ambient[c] = new Vector4(0f, 0f, 0f, 1f);
            block.SetVectorArray("_FluidAmbient", ambient);
        }

        private static Cubemap NewCube(CubemapFace lit, Color colour)
        {
            var made = new Cubemap(4, TextureFormat.RGBAFloat, false);
            for (int face = 0; face < 6; face++)
            {
                for (int i = 0; i < 16; i++) made.SetPixel((CubemapFace)face, i % 4, i / 4, face == (int)lit ? colour : Color.black);
            }
            made.Apply();
            return made;
        }
    }
}
