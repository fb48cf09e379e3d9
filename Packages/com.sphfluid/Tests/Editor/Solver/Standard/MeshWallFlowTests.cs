using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Liquid among triangles, many steps: nothing is lost, nothing boils.</summary>
    public sealed class MeshWallFlowTests
    {
        private const float Spacing = 0.02f;

        private static FluidParticle[] Block(Vector3Int counts, Vector3 low)
        {
            FluidParticle[] particles = ParticleSets.Lattice(counts, Spacing, 0f, 1);
            for (int i = 0; i < particles.Length; i++) particles[i].Position += low + 0.5f * Spacing * (Vector3)counts;
            return particles;
        }

        private static bool IsInside(Transform box, Vector3 position)
        {
            Vector3 p = box.InverseTransformPoint(position);
            return Mathf.Abs(p.x) < 0.5f && Mathf.Abs(p.y) < 0.5f && Mathf.Abs(p.z) < 0.5f;
        }

        [Test]
        public void APoolInABoxOfTrianglesRests()
        {
            var counts = new Vector3Int(8, 10, 8);
            Vector3 size = Vector3.Scale(new Vector3(1f, 2f, 1f), (Vector3)counts) * Spacing;
            FluidRuleInput input = FluidRuleInput.Water;
            input.Method = FluidMethodKind.Standard;
            input.DomainSize = size + 6f * Spacing * Vector3.one;
            input.Spacing = Spacing;
            input.LiquidHeight = input.LiquidDepth = counts.y * Spacing;
            FluidSolverSettings settings = FluidRules.Derive(input);
            using (var rig = new BodyRig(settings))
            {
                Transform box = rig.AddBox(size);
                double depth = counts.y * Spacing, gravity = settings.Gravity.magnitude,
                    soundSquared = (double)settings.SoundSpeed * settings.SoundSpeed;
                FluidParticle[] start = Block(counts, -0.5f * size);
                for (int i = 0; i < start.Length; i++) // pressed together by its weight, so that it does not swing
                {
                    double y = start[i].Position.y + 0.5 * size.y;
                    start[i].Position.y -= (float)(gravity / soundSquared * (depth * y - 0.5 * y * y));
                }
                rig.Start(start);
                double least = double.PositiveInfinity, gained = 0.0;
                for (int part = 0; part < 24; part++)
                {
                    rig.Frame((int)(0.5 * Math.Sqrt(depth / gravity) / settings.TimeStep));
                    float[] densities = GpuTest.Read<float>(rig.Solver.Density, start.Length);
                    double elastic = densities.Select(d => Math.Max(d / (double)settings.RestDensity, 1.0))
                        .Average(r => soundSquared * (Math.Log(r) + 1.0 / r - 1.0));
                    double energy = elastic +
                        rig.Particles().Average(p => 0.5 * p.VelT0.sqrMagnitude + gravity * (p.Position.y + 0.5 * size.y));
                    least = Math.Min(least, energy);
                    gained = Math.Max(gained, energy - least);
                }
                FluidCounters counters = rig.Solver.ReadCountersNow();
                FluidParticle[] particles = rig.Particles();
                double speed = Math.Sqrt(particles.Average(p => (double)p.VelT0.sqrMagnitude)) / Math.Sqrt(gravity * depth);
                double height = 2.0 * (particles.Average(p => (double)p.Position.y) + 0.5 * size.y);
                // Mean depth of a liquid whose density grows by g z/c^2.
                double expected = depth * (1.0 - gravity * depth / (1.5 * soundSquared));
                string figures =
                    $"v_rms {speed:g3}, height {height / expected:f4}, contacts {counters.Contacts} in {rig.Solver.StepCount} steps, " +
                    $"energy gained {gained / least:g3}";
                Assert.That(particles.All(p => IsInside(box, p.Position)), Is.True, figures);
                Assert.That(counters.ContactFallbacks + counters.NonFinite + counters.DomainClamps, Is.Zero, figures);
                Assert.That(counters.Contacts, Is.LessThan(particles.Length * rig.Solver.StepCount / 1000), figures);
                Assert.That(speed, Is.LessThan(0.02), figures);
                Assert.That(gained, Is.LessThan(1e-3 * least), figures);
                Assert.That(height, Is.EqualTo(expected).Within(3.0).Percent, figures); // ten layers between walls
            }
        }

        // A floor, a second one under it, and four walls that go through each other and through both.
        [Test]
        public void APoolInATankOfBoxesThatOverlapRests()
        {
            var counts = new Vector3Int(9, 6, 8);
            Vector3 size = Spacing * (Vector3)counts;
            FluidSolverSettings settings = BodyRig.Water(size + 12f * Spacing * Vector3.one, Spacing, size.y);
            using (var rig = new BodyRig(settings))
            {
                void Wall(Vector3 centre, Vector3 wide) => rig.AddBox(wide).localPosition = centre;
                float thick = 4f * Spacing;
                Vector3 all = size + 2f * thick * Vector3.one;
                foreach (float down in new[] { 0f, 0.3f * Spacing })
                {
                    Wall(-0.5f * (size.y + thick + 2f * down) * Vector3.up, new Vector3(all.x, thick, all.z));
                }
                foreach (float side in new[] { -1f, 1f })
                {
                    Wall(0.5f * side * (size.x + thick) * Vector3.right, new Vector3(thick, all.y, all.z));
                    Wall(0.5f * side * (size.z + thick) * Vector3.forward, new Vector3(all.x, all.y, thick));
                }
                rig.Start(Block(counts, -0.5f * size));
                int steps = (int)(4f / settings.TimeStep / 40f);
                for (int part = 0; part < 40; part++) rig.Frame(steps);
                FluidParticle[] end = rig.Particles();
                double speed = Math.Sqrt(end.Average(p => (double)p.VelT0.sqrMagnitude));
                string figures = $"v_rms {speed:f4} m/s, fastest {end.Max(p => p.VelT0.magnitude):f3}, mean height " +
                    $"{(end.Average(p => p.Position.y) + 0.5f * size.y) / Spacing:f3} dx";
                TestContext.WriteLine(figures);
                Assert.That(end.All(p => Mathf.Abs(p.Position.x) < 0.5f * size.x && Mathf.Abs(p.Position.z) < 0.5f * size.z &&
                    p.Position.y > -0.5f * size.y), figures);
                Assert.That(speed, Is.LessThan(0.012), figures);
            }
        }

        [TestCase(0.1f, false)]
        [TestCase(2f, false)]
        [TestCase(1f, true)]
        public void AShakenBoxLosesNothing(float spacingsPerStep, bool turns)
        {
            const int period = 40;
            float reach = spacingsPerStep * Spacing * period / (2f * Mathf.PI);
            Vector3 size = 10f * Spacing * Vector3.one;
            FluidSolverSettings settings = BodyRig.Water(size + 2f * (reach + 4f * Spacing) * Vector3.one, Spacing, size.y);
            using (var rig = new BodyRig(settings))
            {
                Transform box = rig.AddBox(size);
                rig.Start(Block(new Vector3Int(8, 8, 8), -4f * Spacing * Vector3.one));
                for (int step = 1; step <= 80; step++)
                {
                    float phase = 2f * Mathf.PI * step / period;
                    box.position = turns ? Vector3.zero : reach * new Vector3(Mathf.Sin(phase), 0.3f * Mathf.Sin(2f * phase), 0f);
                    if (turns) box.rotation = Quaternion.AngleAxis(30f * Mathf.Sin(phase), new Vector3(1f, 2f, 3f));
                    rig.Frame(1);
                }
                FluidCounters counters = rig.Solver.ReadCountersNow();
                int lost = rig.Particles().Count(p => !IsInside(box, p.Position));
                Assert.That(lost, Is.Zero,
                    $"contacts {counters.Contacts}, fallbacks {counters.ContactFallbacks}, squeezed {counters.Squeezed}");
                Assert.That(counters.Squeezed + counters.NonFinite + counters.Overlaps, Is.Zero);
                // slower ones the shell keeps off
                if (spacingsPerStep > 1.5f) Assert.That(counters.Contacts, Is.GreaterThan(10), "it met the box");
            }
        }

        [TestCase("scale", 6)]
        [TestCase("scale", 30)]
        [TestCase("uneven", 6)]
        [TestCase("shear", 8)]
        [TestCase("spin", 8)]
        public void ABoxThatStretchesLosesNothing(string motion, int period)
        {
            Vector3 size = 12f * Spacing * Vector3.one;
            FluidSolverSettings settings = BodyRig.Water(3f * size, Spacing, size.y);
            var parent = new GameObject("parent");
            using (var rig = new BodyRig(settings))
            {
                Transform box = rig.AddBox(size);
                box.SetParent(parent.transform, false);
                rig.Start(Block(new Vector3Int(5, 5, 5), -2.5f * Spacing * Vector3.one));
                for (int step = 1; step <= 120; step++)
                {
                    float swing = Mathf.Sin(2f * Mathf.PI * step / period);
                    if (motion == "scale") box.localScale = (1f + 0.4f * swing) * size;
                    else if (motion == "uneven") box.localScale =
                        Vector3.Scale(size, new Vector3(1f + 0.4f * swing, 1f, 1f / (1f + 0.4f * swing)));
                    else parent.transform.localScale = motion == "shear" ? new Vector3(1f + 0.4f * swing, 1f, 1f)
                        : new Vector3(1.5f, 0.8f, 1f);
                    if (motion == "shear") box.localRotation = Quaternion.Euler(35f, 0f, 45f);
                    if (motion == "spin") box.localRotation = Quaternion.AngleAxis(360f * step / period, new Vector3(0.3f, 1f, 0.2f));
                    rig.Frame(1);
                }
                FluidCounters counters = rig.Solver.ReadCountersNow();
                int lost = rig.Particles().Count(p => !IsInside(box, p.Position));
                string figures = $"contacts {counters.Contacts}, fallbacks {counters.ContactFallbacks}, squeezed {counters.Squeezed}";
                UnityEngine.Object.DestroyImmediate(parent);
                Assert.That(lost, Is.Zero, figures);
                Assert.That(counters.Squeezed + counters.NonFinite + counters.Overlaps + rig.Bodies.Jumps, Is.Zero, figures);
                if (period < 10) Assert.That(counters.Contacts, Is.Positive, figures);
            }
        }

        [Test]
        public void ASheetKeepsTwoLiquidsApart()
        {
            Vector3 size = new Vector3(16f, 12f, 6f) * Spacing;
            FluidSolverSettings settings = BodyRig.Water(size, Spacing, 10f * Spacing);
            using (var rig = new BodyRig(settings))
            {
                float y = size.y, z = size.z;
                rig.Add(new[] { new Vector3(0f, -y, -z), new Vector3(0f, y, -z), new Vector3(0f, -y, z), new Vector3(0f, y, -z),
                    new Vector3(0f, y, z), new Vector3(0f, -y, z) });
                FluidParticle[] start = Block(new Vector3Int(8, 10, 6), -0.5f * size)
                    .Concat(Block(new Vector3Int(8, 5, 6), Vector3.Scale(-0.5f * size, new Vector3(0f, 1f, 1f)))).ToArray();
                for (int i = 0; i < start.Length; i++) start[i].Id = (uint)i;
                rig.Start(start);
                for (int frame = 0; frame < 10; frame++) rig.Frame(20);
                FluidParticle[] end = rig.Particles();
                FluidCounters counters = rig.Solver.ReadCountersNow();
                Assert.That(end.Count(p => p.Position.x > 0f != start[p.Id].Position.x > 0f), Is.Zero);
                Assert.That(counters.ContactFallbacks + counters.Squeezed + counters.NonFinite, Is.Zero);
                // The lower liquid does not feel the higher: it stays as high as it was.
                double low = 2.0 * (end.Where(p => p.Position.x > 0f).Average(p => (double)p.Position.y) + 0.5 * size.y);
                Assert.That(low, Is.EqualTo(5.0 * Spacing).Within(5).Percent);
                float fastest = end.Where(p => p.Position.x > 0f).Max(p => p.VelT0.magnitude);
                Assert.That(fastest, Is.LessThan(0.3f * Mathf.Sqrt(settings.Gravity.magnitude * 10f * Spacing)));
            }
        }

        [TestCase(1f)]
        [TestCase(-1f)]
        public void APathThroughAPeriodicFaceHitsWhatIsBehindIt(float side)
        {
            FluidSolverSettings settings = BodyRig.Water(12f * Spacing * Vector3.one, Spacing, 5f * Spacing);
            settings.Boundaries.Periodic = FluidAxes.X;
            using (var rig = new BodyRig(settings))
            {
                // goes on beyond both faces
                rig.Add(new[] { new Vector3(-2f, 0f, -2f), new Vector3(0f, 0f, 2f), new Vector3(2f, 0f, -2f) });
                Vector3 displacement = Spacing * new Vector3(4f * side, -5f, 0f);
                var start = new FluidParticle(new Vector3(5.9f * side * Spacing, 3f * Spacing, 0f), displacement / settings.TimeStep, 0u);
                rig.Start(new[] { start });
                rig.Frame(1);
                FluidParticle end = rig.Particles()[0];
                Assert.That(end.Position.y, Is.GreaterThan(0f), "it did not pass the floor");
                Assert.That(end.Position.x * side, Is.LessThan(0f), "it came in at the other face");
                Assert.That(rig.Solver.ReadCountersNow().Contacts, Is.EqualTo(1));
            }
        }

        [Test]
        public void BadInputIsCountedAndStaysFinite()
        {
            FluidSolverSettings settings = BodyRig.Water(20f * Spacing * Vector3.one, Spacing, 5f * Spacing);
            using (var rig = new BodyRig(settings))
            {
                var corners = new List<Vector3>();
                for (int copy = 0; copy < 1000; copy++)
                {
                    corners.AddRange(new[] { new Vector3(-0.1f, 0f, -0.1f), new Vector3(0f, 0f, 0.1f), new Vector3(0.1f, 0f, -0.1f) });
                }
                corners.AddRange(new[] { Vector3.zero, Vector3.zero, Vector3.zero });
                rig.Add(corners);
                FluidParticle[] start = Block(new Vector3Int(4, 4, 4), 0.5f * Spacing * Vector3.one);
                start[7].VelT0 = new Vector3(float.NaN, 0f, 0f);
                start[9].VelT0 = new Vector3(0f, float.PositiveInfinity, 0f);
                start[11].Position = new Vector3(0.01f, 0f, 0f); // on a triangle
                start[13].VelT0 = new Vector3(0f, -50f * Spacing / settings.TimeStep, 0f);
                rig.Start(start);
                rig.Frame(60);
                FluidCounters counters = rig.Solver.ReadCountersNow();
                FluidParticle[] end = rig.Particles();
                Assert.That(end.All(p => !float.IsNaN(p.Position.sqrMagnitude) && !float.IsInfinity(p.Position.sqrMagnitude)), Is.True);
                Assert.That(end.Select(p => p.Id).Distinct().Count(), Is.EqualTo(start.Length));
                Assert.That(counters.NonFinite, Is.GreaterThanOrEqualTo(2));
                Assert.That(counters.Overlaps, Is.GreaterThanOrEqualTo(1));
                Assert.That(counters.ShortenedSteps + counters.Contacts, Is.GreaterThanOrEqualTo(1));
            }
        }

        [Test]
        public void WithoutTrianglesNothingIsAdded()
        {
            FluidSolverSettings settings = BodyRig.Water(12f * Spacing * Vector3.one, Spacing, 6f * Spacing);
            FluidParticle[] Run(bool empty, out long dispatches, out long bytes)
            {
                using (var rig = new BodyRig(settings))
                {
                    if (empty) rig.Add(new Vector3[0]);
                    rig.Start(Block(new Vector3Int(7, 6, 5), -5f * Spacing * Vector3.one));
                    rig.Setup();
                    long before = ComputeKernel.DispatchesRecorded;
                    GpuTest.Run(cmd => rig.Solver.RecordSteps(cmd, 20));
                    dispatches = ComputeKernel.DispatchesRecorded - before;
                    rig.Setup();
                    bytes = rig.Solver.GpuBytes;
                    return rig.Particles();
                }
            }
            FluidParticle[] none = Run(false, out long count, out long noneBytes),
                empty = Run(true, out long emptyCount, out long emptyBytes);
            Assert.That(empty, Is.EqualTo(none));
            Assert.That(emptyCount, Is.EqualTo(count));
            Assert.That(emptyBytes, Is.EqualTo(noneBytes));
            Assert.That(count, Is.LessThanOrEqualTo(5 * 20));
        }
    }
}
