using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Pressure of water at rest on floor, side wall, mesh and a box under water, by the force on the wall.</summary>
    public sealed class HydrostaticWallForceTests
    {
        private const float Spacing = 0.025f;
        private const int Deep = 14;

        // The faces of a small box within ten: near its edges liquid is held by both faces, beyond the rectangle.
        [Test]
        public void WallsOfStillWaterAreReadWithinFivePercentAndTheFacesOfABoxWithinTen() => Check(0.45, 0.25);

        [Test]
        [Explicit("The table of the paper Standard: half a minute.")]
        public void SoTheyAreForLonger() => Check(0.6, 0.4);

        private static void Check(double settling, double mean)
        {
            // The last two spacings along x are a mesh's, the box is five wide.
            var domain = Spacing * new Vector3(20f, Deep + 3f, 12f);
            FluidSolverSettings settings = BodyRig.Water(domain, Spacing, Deep * Spacing);
            settings.Viscosity = 0.01f; // comes to rest soon
            Vector3 box = 5f * Spacing * Vector3.one, centre = new Vector3(-Spacing, -0.5f * domain.y + 6.5f * Spacing, 0f);
            Vector3 clear = 0.5f * box + 0.4f * Spacing * Vector3.one;
            FluidParticle[] water = WallForceRig.Block(new Vector3Int(18, Deep, 12), Spacing, -0.5f * domain, Vector3.zero)
                .Where(p => Mathf.Abs(p.Position.x - centre.x) > clear.x || Mathf.Abs(p.Position.y - centre.y) > clear.y ||
                    Mathf.Abs(p.Position.z) > clear.z).ToArray();
            for (int i = 0; i < water.Length; i++) water[i].Id = (uint)i;
            using (var rig = new WallForceRig(settings, water))
            {
                float face = 0.5f * domain.x - 2f * Spacing, floor = -0.5f * domain.y;
                rig.Obstacles
                    .Add(
                        TriangleMesh.Box(Matrix4x4.TRS(new Vector3(face + 2f * Spacing, 0f, 0f), Quaternion.identity,
                            new Vector3(4f * Spacing, 2f * domain.y, 2f * domain.z))), Matrix4x4.identity);
                rig.Obstacles.Add(TriangleMesh.Box(Matrix4x4.TRS(centre, Quaternion.identity, box)), Matrix4x4.identity);
                float middle = floor + 5f * Spacing;
                var patches = new Dictionary<string, WallPatch>
                {
                    ["floor"] = rig.Add(new Vector3(-Spacing, floor, 0f), Vector3.up, 12f * Spacing, 8f * Spacing),
                    ["side wall"] = rig.Add(new Vector3(-0.5f * domain.x, middle, 0f), Vector3.right, 8f * Spacing, 6f * Spacing),
                    ["mesh"] = rig.Add(new Vector3(face, middle, 0f), Vector3.left, 8f * Spacing, 6f * Spacing),
                    ["top of the box"] = rig.Add(centre + 0.5f * box.y * Vector3.up, Vector3.up, 4f * Spacing, 4f * Spacing),
                    ["bottom of the box"] = rig.Add(centre - 0.5f * box.y * Vector3.up, Vector3.down, 4f * Spacing, 4f * Spacing),
                    ["side of the box"] = rig.Add(centre + 0.5f * box.x * Vector3.right, Vector3.right, 4f * Spacing, 4f * Spacing),
                };
                foreach (WallPatch patch in patches.Values) patch.Memory = 2.0;
                rig.Play(settling);
                var particles = patches.Values.ToDictionary(p => p, p => 0.0);
                const int turns = 8;
                for (int turn = 0; turn < turns; turn++)
                {
                    rig.Play(mean / turns);
                    FluidParticle[] now = rig.Particles();
                    float[] pressures = rig.Pressures();
                    foreach (WallPatch patch in patches.Values) particles[patch] += rig.Shepard(now, pressures, patch.Centre) / turns;
                }
                double area = (double)(domain.x - 2f * Spacing) * domain.z;
                double level = floor +
                    (water.Length * (double)settings.ParticleMass / settings.RestDensity + (double)box.x * box.y * box.z) / area;
                var figures = new List<string>();
                bool within = true;
                foreach (KeyValuePair<string, WallPatch> patch in patches)
                {
                    double expected = settings.RestDensity * -settings.Gravity.y * (level - patch.Value.Centre.y);
                    double ratio = patch.Value.MeanPressure(mean) / expected;
                    within &= Math.Abs(ratio - 1.0) < (patch.Key.EndsWith("box") ? 0.1 : 0.05);
                    figures.Add($"{patch.Key} {ratio:f3} of {expected:f0} Pa (mean of particles {particles[patch.Value] / expected:f3})");
                }
                TestContext.WriteLine(string.Join("; ", figures));
                Assert.That(within, Is.True, string.Join("; ", figures));
            }
        }
    }
}
