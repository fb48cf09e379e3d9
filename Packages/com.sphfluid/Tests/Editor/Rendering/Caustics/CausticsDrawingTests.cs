using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>
    /// Caustics on a floor under waves of known shape, against light followed by Snell's law on the CPU. The domain is a cube of 1 m.
    /// </summary>
    public sealed class CausticsDrawingTests
    {
        private const int Size = WaterRig.Size;
        private const float Floor = -0.4f;
        private const float WaveNumber = 2f * Mathf.PI / 0.25f; // four waves across the domain
        private const double Texel = 0.75 * WaterRig.Spacing;
        private const double Index = 1.0 / 0.75;

        private static readonly Vector3 Above = Vector3.up;
        private static readonly Vector3 Aslant = new Vector3(0.3f, 0.8f, 0.2f);

        private WaterRig rig;

        [SetUp]
        public void SetUp()
        {
            rig = new WaterRig { Domain = new Bounds(Vector3.zero, Vector3.one), Eye = new Vector3(0f, 1.5f, -1.5f) };
            rig.ShowPlaces();
            rig.Look.Caustics = 1f;
            ShowFloor(Floor);
        }

        [TearDown]
        public void TearDown() => rig.Dispose();

        [Test]
        public void CalmWaterChangesNothing([Values] bool aslant, [Values] bool perspective)
        {
            rig.Perspective = perspective;
            ShowFloor(Floor);
            Waves(0f);
            ForEach(rig.RenderCaustics(aslant ? Aslant : Above, Color.white), 0.25f,
                (point, gain) => Assert.AreEqual(1f, gain.g, 2e-3f, $"at {point}"));
        }

        // Crests are lenses: 5 mm gather light towards a line below the floor, 20 mm above it, so that rays cross. A wave has thirteen
        // texels of the map.
        [TestCase(0.005f, 0.02f)]
        [TestCase(0.02f, 0.2f)]
        public void WavesGatherAsMuchLightAsSnellsLawSays(float amplitude, float tolerance)
        {
            Waves(amplitude);
            double squares = 0.0;
            int count = 0;
            float most = 0f;
            ForEach(rig.RenderCaustics(Above, Color.white), 0.3f, (point, gain) =>
            {
                double off = gain.g - Arriving(point.x, amplitude);
                squares += off * off;
                count++;
                most = Mathf.Max(most, gain.g);
            });
            Assert.Less(Math.Sqrt(squares / count), tolerance, "root of the mean square");
            Assert.Greater(most, 1.25f);
        }

        // Over a wave as much arrives as goes in.
        [TestCase(0.005f)]
        [TestCase(0.02f)]
        public void NoLightIsLost(float amplitude)
        {
            Waves(amplitude);
            double sum = 0.0;
            int count = 0;
            ForEach(rig.RenderCaustics(Above, Color.white), 0.25f, (point, gain) =>
            {
                sum += gain.g;
                count++;
            });
            Assert.AreEqual(1.0, sum / count, 0.02);
        }

        [Test]
        public void NothingChangesAboveTheWater()
        {
            ShowFloor(0.05f);
            Waves(0.02f);
            Assert.IsTrue(rig.RenderCaustics(Above, Color.white).All(gain => gain == Color.white));
        }

        [Test]
        public void WithoutLightNothingChanges()
        {
            Waves(0.02f);
            Assert.IsTrue(rig.RenderCaustics(Above, Color.black).All(gain => gain == Color.white));
        }

        // A film as thin as a spacing lets light through as it came.
        [Test]
        public void AFilmGathersNoLight()
        {
            Waves(0.02f, -0.01f);
            ForEach(rig.RenderCaustics(Above, Color.white), 0.3f, (point, gain) => Assert.AreEqual(1f, gain.g, 1e-3f, $"at {point}"));
        }

        [Test]
        public void WhatIsScatteredIsMissingAndWhatIsAbsorbedIsNot()
        {
            Waves(0.005f);
            Color[] clear = rig.RenderCaustics(Above, Color.white);
            rig.Look.ColorAtOneMetre = new Color(0.1f, 0.5f, 1f);
            rig.Look.Visibility = 2f;
            rig.Look.Scattering = new Color(1f, 0.5f, 0f);
            Color[] tinted = rig.RenderCaustics(Above, Color.white);
            int brightest = Enumerable.Range(0, clear.Length).OrderByDescending(i => clear[i].g).First();
            for (int c = 0; c < 3; c++)
            {
                float left = Mathf.Exp(Floor * rig.Look.Extinction[c] * rig.Look.Albedo[c]);
                Assert.AreEqual(1f + (clear[brightest][c] - 1f) * left, tinted[brightest][c], 0.02f, $"channel {c}");
            }
        }

        [Test]
        public void NoneCostNothing()
        {
            Waves(0.02f);
            rig.RenderCaustics(Above, Color.white);
            Assert.AreEqual(1, WaterCaustics.Count);
            rig.Look.Caustics = 0f;
            rig.Render();
            Assert.AreEqual(0, WaterCaustics.Count);
        }

        // Water of these waves over a flat bottom.
        private void Waves(float amplitude, float bottom = -0.5f)
        {
            rig.Surface = new UploadedSurface()
                .Waves(1f, 400, x => amplitude * Mathf.Cos(WaveNumber * x),
                    x => new Vector3(amplitude * WaveNumber * Mathf.Sin(WaveNumber * x), 1f, 0f))
                .Quad(new Vector3(0f, bottom, 0f), Vector3.right * 0.5f, Vector3.forward * 0.5f, Vector3.down);
        }

        private void ShowFloor(float height) =>
            rig.SetDepth((x, y) => -SurfaceTestScene.LookAtOrigin(rig.Eye).MultiplyPoint(FloorAt(x, y, height)).z);

        // Pixels whose point of the floor is no farther from its middle.
        private void ForEach(Color[] picture, float reach, Action<Vector3, Color> check)
        {
            int checkedPixels = 0;
            for (int i = 0; i < picture.Length; i++)
            {
                Vector3 point = FloorAt(i % Size, i / Size, Floor);
                if (Mathf.Abs(point.x) > reach || Mathf.Abs(point.z) > reach) continue;
                check(point, picture[i]);
                checkedPixels++;
            }
            Assert.Greater(checkedPixels, 200);
        }

        private Vector3 FloorAt(int x, int y, float height)
        {
            Vector3 aside = Quaternion.LookRotation(-rig.Eye, Vector3.up) *
                new Vector3(2f * (x + 0.5f) / Size - 1f, 2f * (y + 0.5f) / Size - 1f, 0f);
            Vector3 start = rig.Perspective ? rig.Eye : rig.Eye + aside * WaterRig.HalfWidth;
            Vector3 sight = rig.Perspective ? -rig.Eye.normalized + aside * WaterRig.HalfAngle : -rig.Eye.normalized;
            return start + sight * ((height - start.y) / sight.y);
        }

        // Light from above around a place of the floor, to that without waves: by the spline of three texels that the picture is made with.
        private static double Arriving(double place, double amplitude)
        {
            const double step = 1e-4;
            double sum = 0.0;
            for (double x = -0.5; x < 0.5; x += step)
            {
                double tilt = Math.Atan(amplitude * WaveNumber * Math.Sin(WaveNumber * x));
                double aside = Math.Tan(Math.Asin(Math.Sin(tilt) / Index) - tilt);
                double hit = x + aside * (amplitude * Math.Cos(WaveNumber * x) - Floor);
                double away = Math.Abs(hit - place) / Texel;
                sum += away < 0.5 ? 0.75 - away * away : 0.5 * Math.Pow(Math.Max(1.5 - away, 0.0), 2);
            }
            return sum * step / Texel;
        }
    }
}
