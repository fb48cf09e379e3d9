using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Pressure of water at rest on floor, side wall, mesh and a box under water: the force on them, to the edges.</summary>
    public sealed class HydrostaticWallForceTests
    {
        private const float Spacing = 0.025f;
        private const int Deep = 14;

        [Test]
        public void StillWaterIsReadWithinFivePercentInEveryRowAndOnWholeFacesOfABox() => Check(0.9, 0.6);

        [Test]
        [Explicit("The table of the manual: half a minute.")]
        public void SoItIsForLonger() => Check(1.0, 2.0);

        // Rows of a spacing run along the edges of floor, walls and box; the box's faces are read by rectangles that overhang them.
        private static void Check(double settling, double mean)
        {
            // The last two spacings along x are a mesh's, the box is six wide.
            var domain = Spacing * new Vector3(20f, Deep + 3f, 12f);
            FluidSolverSettings settings = BodyRig.Water(domain, Spacing, Deep * Spacing);
            settings.Viscosity = 0.01f; // comes to rest soon
            Vector3 box = 6f * Spacing * Vector3.one, centre = new Vector3(-Spacing, -0.5f * domain.y + 7f * Spacing, 0f);
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
                float middle = floor + 5f * Spacing, left = -0.5f * domain.x, wide = box.x + 1.3f * Spacing;
                var patches = new Dictionary<string, WallPatch>
                {
                    ["floor"] = rig.Add(new Vector3(-Spacing, floor, 0f), Vector3.up, 12f * Spacing, 8f * Spacing),
                    ["side wall"] = rig.Add(new Vector3(left, middle, 0f), Vector3.right, 8f * Spacing, 6f * Spacing),
                    ["mesh"] = rig.Add(new Vector3(face, middle, 0f), Vector3.left, 8f * Spacing, 6f * Spacing),
                    ["top of the box"] = rig.Add(centre + 0.5f * box.y * Vector3.up, Vector3.up, wide, wide),
                    ["bottom of the box"] = rig.Add(centre - 0.5f * box.y * Vector3.up, Vector3.down, wide, wide),
                    ["side of the box"] = rig.Add(centre + 0.5f * box.x * Vector3.right, Vector3.right, wide, wide),
                };
                for (int row = 0; row < 4; row++)
                {
                    float at = (row + 0.5f) * Spacing, inBox = 0.5f * box.x - at;
                    patches[$"side wall, row {row}"] =
                        rig.Add(new Vector3(left, floor + at, 0f), Vector3.right, 8f * Spacing, Spacing);
                    patches[$"mesh, row {row}"] = rig.Add(new Vector3(face, floor + at, 0f), Vector3.left, 8f * Spacing, Spacing);
                    patches[$"floor, row {row}"] = rig.Add(new Vector3(left + at, floor, 0f), Vector3.up, Spacing, 8f * Spacing);
                    patches[$"floor at the mesh, row {row}"] =
                        rig.Add(new Vector3(face - at, floor, 0f), Vector3.up, Spacing, 8f * Spacing);
                    patches[$"top of the box, row {row}"] =
                        rig.Add(centre + new Vector3(inBox, 0.5f * box.y, 0f), Vector3.up, Spacing, box.z);
                    patches[$"side of the box, row {row}"] =
                        rig.Add(centre + new Vector3(0.5f * box.x, inBox, 0f), Vector3.right, box.z, Spacing);
                }
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
                    within &= Math.Abs(ratio - 1.0) < 0.05;
                    figures.Add($"{patch.Key} {ratio:f3} of {expected:f0} Pa (mean of particles {particles[patch.Value] / expected:f3})");
                }
                double lift = patches["bottom of the box"].MeanForce(mean) - patches["top of the box"].MeanForce(mean);
                double buoyancy = lift / (settings.RestDensity * -settings.Gravity.y * box.x * box.y * box.z);
                within &= Math.Abs(buoyancy - 1.0) < 0.03;
                figures.Add($"buoyancy {buoyancy:f3}");
                TestContext.WriteLine(string.Join("\n", figures));
                Assert.That(within, Is.True, string.Join("; ", figures));
            }
        }
    }
}
