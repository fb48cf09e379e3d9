using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Ground that comes out of the domain's floor at any angle and the floor are one wall: their shares join smoothly.</summary>
    public sealed class WallsOverFacesTests
    {
        private const float Spacing = 0.05f, Half = 0.6f;

        private static readonly FluidSolverSettings Settings = BodyRig.Water(2f * Half * Vector3.one, Spacing, 0.3f);

        // A sheet through the line y = -Half + above, x = 0 that rises towards +x, by degrees over the floor.
        private static List<Vector3> Slope(float degrees, float above = 0f)
        {
            float rise = degrees * Mathf.Deg2Rad;
            Vector3 along = new Vector3(Mathf.Cos(rise), Mathf.Sin(rise), 0f), across = 2f * Half * Vector3.forward,
                at = (above - Half) * Vector3.up;
            Vector3 a = at - Half * along - across, b = at + Half * along - across;
            return new List<Vector3> { a, a + 2f * across, b, b, a + 2f * across, b + 2f * across };
        }

        // 0.3 to 0.9 spacings from both or from one of them, on the side on which the wedge opens by 180 degrees less the slope's.
        private static Vector3[] Beside(float degrees, int count, float above)
        {
            var random = new System.Random(5);
            float Next(float from, float to) => from + (to - from) * (float)random.NextDouble();
            float rise = degrees * Mathf.Deg2Rad;
            var normal = new Vector3(-Mathf.Sin(rise), Mathf.Cos(rise), 0f);
            var points = new List<Vector3>();
            while (points.Count < count)
            {
                var p = new Vector3(Next(-4f, 4f) * Spacing, Next(0.3f, 1.8f) * Spacing - Half, Next(-1f, 1f) * Spacing);
                float fromSlope = Vector3.Dot(normal, p - (above - Half) * Vector3.up);
                if (fromSlope > 0.3f * Spacing && Mathf.Min(fromSlope, p.y + Half) < 0.9f * Spacing) points.Add(p);
            }
            return points.ToArray();
        }

        // Beside a flat wall, too, what is kept to second order is wrong by up to 0.03.
        [Test]
        public void WhatIsKeptHoldsUntilItIsGatheredAnew([Values(3f, 11f, 30f, 60f, 90f, 120f)] float degrees,
            [Values(0f, 0.02f)] float above)
        {
            const int count = 500;
            var random = new System.Random(9);
            Vector3[] points = Beside(degrees, count, above);
            StoredWall[] walls = WallEnergyTests.Gather(Slope(degrees, above), points);
            Vector3[] gone = points.Select((p, i) => p +
                (walls[i].IsBrief ? 0.019f : 0.065f) * Settings.SupportRadius * ParticleSets.RandomVector(random).normalized).ToArray();
            StoredWall[] anew = WallEnergyTests.Gather(Slope(degrees, above), gone);
            // Without a triangle within R the faces serve without walls.
            double[] wrong = Enumerable.Range(0, count).Where(i => walls[i].Value > 0.0 && anew[i].Value > 0.0)
                .Select(i => Math.Abs(walls[i].From(gone[i]).Value - anew[i].Value)).ToArray();
            TestContext.WriteLine(
                $"by up to {wrong.Max():f4} of {wrong.Length}, {walls.Count(w => w.IsBrief)} of them serve for a short way");
            Assert.That(wrong, Has.Length.GreaterThan(count / 4));
            Assert.That(wrong.Max(), Is.LessThan(0.04));
        }

        [Test]
        public void WaterOverGroundThatComesOutOfTheFloorRests()
        {
            FluidSolverSettings settings = BodyRig.Water(new Vector3(0.7f, 0.6f, 0.5f), Spacing, 0.2f);
            using (var rig = new BodyRig(settings))
            {
                var ground = new List<Vector3>();
                float Height(float x, float z) => -0.31f + 0.06f * Mathf.Sin(11f * x + 0.3f) * Mathf.Cos(9f * z);
                Vector3 At(int x, int z) => new Vector3(0.1f * x, Height(0.1f * x, 0.1f * z), 0.1f * z);
                for (int x = -5; x < 5; x++)
                    for (int z = -4; z < 4; z++)
                    {
                        ground.AddRange(new[] { At(x, z), At(x, z + 1), At(x + 1, z), At(x + 1, z), At(x, z + 1), At(x + 1, z + 1) });
                    }
                rig.Add(ground);
                rig.Start(ParticleSets.Lattice(new Vector3Int(14, 5, 10), Spacing, 0.02f * Spacing, 3)
                    .Select(p => p.Position - (0.3f - 2.5f * Spacing) * Vector3.up)
                    .Where(p => p.y > Height(p.x, p.z) + 0.5f * Spacing).Select((p, i) => new FluidParticle(p, Vector3.zero, (uint)i))
                    .ToArray());
                int steps = Mathf.CeilToInt(2f / settings.TimeStep);
                for (int frame = 0; frame < steps / 8; frame++) rig.Frame(8);
                double speed = Math.Sqrt(rig.Particles().Average(p => (double)p.VelT0.sqrMagnitude));
                TestContext.WriteLine($"{speed:f4} m/s after {steps} steps");
                Assert.That(speed, Is.LessThan(0.14));
            }
        }
    }
}
