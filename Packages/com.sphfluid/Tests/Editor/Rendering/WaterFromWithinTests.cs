using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>The picture of a camera in the water, against Beer's law and the law of refraction.</summary>
    public sealed class WaterFromWithinTests
    {
        private const int Size = WaterRig.Size;

        private WaterRig rig;

        [SetUp]
        public void SetUp() => rig = new WaterRig();

        [TearDown]
        public void TearDown() => rig.Dispose();

        // The camera stands 2 m before the far face, 0.1 m of which lie before its near plane and count as well.
        [Test]
        public void TheSceneFadesOnItsWayThroughTheWater()
        {
            Fill(new Vector3(0f, 0f, 1f));
            rig.SetDepth((x, y) => 1.5f);
            Color seen = WaterRig.Centre(rig.Render(fromWithin: true));
            for (int c = 0; c < 3; c++)
            {
                Assert.AreEqual(rig.Scene.GetPixel(0, 0)[c] * Mathf.Exp(-1.5f * rig.Look.Extinction[c]), seen[c], 2e-3f, $"channel {c}");
            }
        }

        [Test]
        public void ASurfaceAheadLetsTheSceneBehindItThrough()
        {
            Fill(new Vector3(0f, 0f, 1f));
            Color seen = WaterRig.Centre(rig.Render(fromWithin: true));
            for (int c = 0; c < 3; c++)
            {
                Assert.AreEqual(rig.Scene.GetPixel(0, 0)[c] * 0.98f * Mathf.Exp(-2f * rig.Look.Extinction[c]), seen[c], 3e-3f,
                    $"channel {c}");
            }
        }

        // At 0.7 rad to the normal in the water, 0.93 times the critical sine, light leaves at asin(1.333 sin 0.7). Out there it goes on to
        // the scene, 0.3 m behind.
        [Test]
        public void TheWindowBendsByTheLawOfRefraction()
        {
            rig.ShowPlaces();
            rig.SetDepth((x, y) => 2.3f);
            Fill(Normal(0.7f));
            float turned = Mathf.Asin(Mathf.Sin(0.7f) * 4f / 3f) - 0.7f;
            Color seen = WaterRig.Centre(rig.Render(fromWithin: true));
            float place = (Size / 2 + 0.5f) / Size + 0.3f * Mathf.Tan(turned) / (2f * WaterRig.HalfWidth);
            float left = 1f - Fresnel(Mathf.Cos(0.7f + turned));
            Assert.AreEqual(place, seen.r / left, 0.02f);
        }

        // Beyond the critical angle, asin(0.75) = 0.848 rad, the surface mirrors: light stays in the water and goes on to the right.
        [Test]
        public void BeyondTheCriticalAngleTheSurfaceMirrors()
        {
            rig.ReplaceScene((x, y) => x > Size / 2 + 1 ? Color.red : Color.green);
            rig.Look.ColorAtOneMetre = Color.white;
            rig.Look.Visibility = 1e6f;
            rig.SetDepth((x, y) => x > Size / 2 + 1 ? 2.05f : WaterRig.Far);
            Fill(Normal(1.2f));
            Color seen = WaterRig.Centre(rig.Render(fromWithin: true));
            Assert.Greater(seen.r, 0.9f, "what stands in the water on the right");
            Assert.Less(seen.g, 0.1f);
        }

        // The mirrored line leaves the picture on the right: its border must not be drawn out over all that lies beside it.
        [Test]
        public void WhatLiesBesideThePictureIsNotItsBorder()
        {
            rig.ReplaceScene((x, y) => x > Size - 3 || x < 2 ? Color.red : Color.green);
            rig.Look.ColorAtOneMetre = Color.white;
            rig.Look.Visibility = 1e6f;
            rig.SetDepth((x, y) => WaterRig.Far);
            Fill(Normal(1.2f));
            Color seen = WaterRig.Centre(rig.Render(fromWithin: true));
            Assert.Greater(seen.g, 0.9f);
            Assert.Less(seen.r, 0.1f);
        }

        [Test]
        public void ACameraOutsideSeesNothingOfIt()
        {
            rig.Box(0.4f);
            Color seen = WaterRig.Centre(rig.Render(background: Color.magenta, fromWithin: true));
            Assert.AreEqual(Color.magenta.r, seen.r, 1e-3f);
            Assert.AreEqual(Color.magenta.g, seen.g, 1e-3f);
        }

        // Water from behind the camera to the origin, where a face of any normal ends it.
        private void Fill(Vector3 normal)
        {
            rig.Domain = new Bounds(Vector3.zero, Vector3.one * 8f);
            rig.Surface = new UploadedSurface().Quad(Vector3.zero, Vector3.right * 3.9f, Vector3.up * 3.9f, normal);
        }

        // Leans to the left, away from the camera.
        private static Vector3 Normal(float angle) => new Vector3(-Mathf.Sin(angle), 0f, Mathf.Cos(angle));

        private static float Fresnel(float cosine) => 0.02f + 0.98f * Mathf.Pow(1f - cosine, 5f);
    }
}
