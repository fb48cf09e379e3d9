using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid.Tests
{
    /// <summary>
    /// Where drops of spray are drawn: after the water, or into the picture that the water refracts; never in both of a pixel.
    /// </summary>
    public sealed class SprayDrawingTests
    {
        private const float Spacing = 0.1f;

        private WaterRig rig;

        [SetUp]
        public void SetUp()
        {
            rig = new WaterRig();
            rig.SetDepth((x, y) => 4f);
        }

        [TearDown]
        public void TearDown() => rig.Dispose();

        // Water from z = -0.2 m to 0.2 m, and a camera 2 m before the origin.
        [TestCase(-0.6f, true, false, TestName = "{m}(before the water)")]
        [TestCase(0.6f, true, true, TestName = "{m}(behind it, where the surface's depth hides what was drawn after the water)")]
        public void FromOutside(float z, bool after, bool refracted)
        {
            rig.Box(0.4f);
            Shows(z, after, refracted);
        }

        // The water reaches from behind the camera to z = 0.
        [TestCase(-0.6f, true, false, TestName = "{m}(in the water)")]
        [TestCase(0.6f, false, true, TestName = "{m}(in the air, seen through the water's window only)")]
        public void FromWithin(float z, bool after, bool refracted)
        {
            rig.Domain = new Bounds(Vector3.zero, Vector3.one * 8f);
            rig.Surface = new UploadedSurface().Quad(Vector3.zero, Vector3.right * 3.9f, Vector3.up * 3.9f, Vector3.forward);
            Shows(z, after, refracted);
        }

        [Test]
        public void WhatTheSceneHidesIsNotRefracted()
        {
            rig.Box(0.4f);
            rig.SetDepth((x, y) => WaterRig.Distance + 0.3f);
            Assert.IsFalse(IsShown(rig.RenderSpray(new Vector3(0f, 0f, 0.6f), Spacing, behind: true)));
        }

        // Liquids of some colour: what is left after a metre, how far one sees in it, what it scatters.
        [TestCase(0.86f, 0.37f, 0.001f, 2.5f, 1f, 0.7f, 0.3f, TestName = "{m}(honey)")]
        [TestCase(0.8f, 0.66f, 0.02f, 6f, 1f, 0.9f, 0.5f, TestName = "{m}(oil)")]
        [TestCase(0.5f, 0.01f, 0.01f, 0.02f, 0.7f, 0.02f, 0.03f, TestName = "{m}(blood)")]
        [TestCase(0.4f, 0.9f, 0.1f, 0.3f, 0.4f, 0.9f, 0.2f, TestName = "{m}(slime)")]
        [TestCase(0.1f, 0.52f, 0.83f, 8f, 1f, 1f, 1f, TestName = "{m}(water)")]
        public void ItHasTheHueOfItsLiquid(float red, float green, float blue, float visibility, float red2, float green2, float blue2)
        {
            rig.Look.ColorAtOneMetre = new Color(red, green, blue);
            rig.Look.Visibility = visibility;
            rig.Look.Scattering = new Color(red2, green2, blue2);
            rig.ReplaceScene((x, y) => Color.white);
            rig.Box(0.4f);
            using var light = new WhiteLight(Vector3.up);
            Vector3 before = new Vector3(0f, 0.99f, -0.14f); // of the face that is looked at, which may be matt
            Color.RGBToHSV(WaterRig.Centre(rig.Render(block =>
            {
                block.SetVector("_FluidLightColour", Vector4.one);
                block.SetVector("_FluidLightDirection", before);
            })).gamma, out float hue, out _, out _);
            Color.RGBToHSV(Light(rig.RenderSpray(Before, Spacing, behind: false)).gamma, out float spray, out float saturation, out _);
            Assert.Less(Mathf.Abs(Mathf.DeltaAngle(360f * hue, 360f * spray)), 10f);
            Assert.Greater(saturation, 0.02f);
        }

        [TestCase(1f, 0.98f, 0.92f, 0.02f, TestName = "{m}(milk)")]
        [TestCase(0.1f, 0.52f, 0.83f, 8f, TestName = "{m}(water)")]
        public void ItIsWhiteWhereTheLiquidIs(float red, float green, float blue, float visibility)
        {
            rig.Look.ColorAtOneMetre = new Color(red, green, blue);
            rig.Look.Visibility = visibility;
            rig.Box(0.4f);
            using var light = new WhiteLight(Vector3.up);
            Color.RGBToHSV(Light(rig.RenderSpray(Before, Spacing, behind: false)).gamma, out _, out float saturation, out float value);
            Assert.Less(saturation, 0.1f);
            Assert.Greater(value, 0.5f);
        }

        [Test]
        public void TheSideToTheLightIsTheBrighterOne([Values(-1f, 1f)] float side)
        {
            rig.Box(0.4f);
            using var light = new WhiteLight(Vector3.right * side);
            Color[] mist = rig.RenderSpray(Before, Spacing, behind: false, drops: 1);
            float left = mist.Where((pixel, i) => i % WaterRig.Size < WaterRig.Size / 2).Sum(pixel => pixel.g);
            float right = mist.Where((pixel, i) => i % WaterRig.Size >= WaterRig.Size / 2).Sum(pixel => pixel.g);
            Assert.Greater(side > 0f ? right / left : left / right, 1.25f);
        }

        [Test]
        public void LightFromBelowIsSeenAsWell()
        {
            rig.Box(0.4f);
            float Brightness(Vector3 to)
            {
                using var light = new WhiteLight(to);
                return Light(rig.RenderSpray(Before, Spacing, behind: false, drops: 1)).g;
            }
            Assert.AreEqual(1f, Brightness(Vector3.down) / Brightness(Vector3.up), 0.05f);
            Assert.Greater(Brightness(Vector3.forward), 0.4f * Brightness(Vector3.back), "against the light");
        }

        // A puff of a radius of 0.15 m before a wall.
        [TestCase(0.15f, 1f)]
        [TestCase(0.075f, 0.5f)]
        [TestCase(0.015f, 0.1f)]
        public void MistFadesTowardsASurface(float metres, float expected)
        {
            rig.Box(0.4f);
            float free = WaterRig.Centre(rig.RenderSpray(Before, Spacing, behind: false, drops: 1)).a;
            rig.SetDepth((x, y) => WaterRig.Distance + Before.z + metres);
            float near = WaterRig.Centre(rig.RenderSpray(Before, Spacing, behind: false, drops: 1)).a;
            Assert.AreEqual(expected, near / free, 0.02f);
        }

        // The same puff before a pane of water, and before two: only where a thick first one ends is known.
        [TestCase(0.4f, 1, 0.15f, 1f)]
        [TestCase(0.4f, 1, 0.075f, 0.5f)]
        [TestCase(0.4f, 1, 0.015f, 0.1f)]
        [TestCase(0.01f, 2, 0.065f, 0.5f)]
        [TestCase(0.4f, 2, 0.075f, 1f)]
        public void MistFadesTowardsTheWater(float thickness, int panes, float metres, float expected)
        {
            var surface = new UploadedSurface();
            for (int i = 0; i < panes; i++) surface.Box(Vector3.forward * i, new Vector3(4f, 4f, thickness));
            rig.Surface = surface;
            float free = WaterRig.Centre(rig.RenderSpray(Vector3.back, Spacing, behind: false, drops: 1)).a;
            Vector3 near = new Vector3(0f, 0f, -0.5f * thickness - metres);
            float faded = WaterRig.Centre(rig.RenderSpray(near, Spacing, behind: false, drops: 1)).a;
            Assert.AreEqual(expected, faded / free, 0.02f);
        }

        // As lava does; of clear water that shines, a drop is too small for it.
        [TestCase(0.1f, 1f)]
        [TestCase(1000f, 0f)]
        public void ItGlowsAsItsLiquidDoes(float visibility, float expected)
        {
            rig.Look.Scattering = Color.white;
            rig.Look.ColorAtOneMetre = Color.white;
            rig.Look.Visibility = visibility;
            rig.Box(0.4f);
            Color Glow(Color emission)
            {
                rig.Look.Emission = emission;
                return Light(rig.RenderSpray(Before, Spacing, behind: false));
            }
            Color glow = Glow(new Color(1f, 0f, 0f)) - Glow(Color.black);
            Assert.AreEqual(expected, glow.r, 0.03f);
            Assert.AreEqual(0f, glow.g + glow.b, 1e-3f);
        }

        private static Vector3 Before => new Vector3(0f, 0f, -0.6f);

        // Of all pixels, as a share of what they cover.
        private static Color Light(Color[] picture)
        {
            Color sum = picture.Aggregate((a, b) => a + b);
            return sum / sum.a;
        }

        private void Shows(float z, bool after, bool refracted)
        {
            Assert.AreEqual(after, IsShown(rig.RenderSpray(new Vector3(0f, 0f, z), Spacing, behind: false)), "after the water");
            Assert.AreEqual(refracted, IsShown(rig.RenderSpray(new Vector3(0f, 0f, z), Spacing, behind: true)),
                "into the picture that the water refracts");
        }

        private static bool IsShown(Color[] picture) => picture.Any(pixel => pixel.a > 0.01f);

        // One light from a direction, and no other.
        private readonly struct WhiteLight : System.IDisposable
        {
            private readonly Light lamp;
            private readonly Light sun;
            private readonly (AmbientMode Mode, SphericalHarmonicsL2 Probe) ambient;

            public WhiteLight(Vector3 to)
            {
                ambient = (RenderSettings.ambientMode, RenderSettings.ambientProbe);
                sun = RenderSettings.sun;
                (RenderSettings.ambientMode, RenderSettings.ambientProbe) = (AmbientMode.Flat, default);
                lamp = new GameObject("Light").AddComponent<Light>();
                lamp.type = LightType.Directional;
                lamp.transform.rotation = Quaternion.LookRotation(-to);
                RenderSettings.sun = lamp;
            }

            public void Dispose()
            {
                (RenderSettings.ambientMode, RenderSettings.ambientProbe) = ambient;
                RenderSettings.sun = sun;
                Object.DestroyImmediate(lamp.gameObject);
            }
        }
    }
}
