using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Drops of water of 1 mm and 6 particles radius: what surface tension does to them, against formulas.</summary>
    public sealed class DropTests
    {
        private const float Radius = 1e-3f, Spacing = Radius / 6f, Tension = 0.0728f;

        // Lamb: ω² = 8 σ/(ρ R³) for the drop that is long and flat in turn; 8.23 ms here.
        private static double LambPeriod => 2.0 * Math.PI / Math.Sqrt(8.0 * Tension / (1000.0 * Math.Pow(Radius, 3.0)));

        [Test]
        public void ADropSwingsWithLambsPeriod()
        {
            FluidSolverSettings settings = Water(90f);
            FluidParticle[] start = Rest(settings).Select(p =>
                new FluidParticle(new Vector3(0.93f * p.Position.x, 1.15f * p.Position.y, 0.93f * p.Position.z), Vector3.zero, p.Id))
                .ToArray();
            using (var rig = new StandardRig(settings, start))
            {
                var samples = new List<(double Time, double Length)> { (0.0, Lengthening(start)) };
                int parts = Math.Max(1, (int)(LambPeriod / 40.0 / settings.TimeStep));
                while (rig.Solver.SimulatedTime < 1.3 * LambPeriod)
                {
                    rig.Steps(parts);
                    samples.Add((rig.Solver.SimulatedTime, Lengthening(rig.Particles())));
                }
                double[] crossings = Enumerable.Range(1, samples.Count - 1)
                    .Where(i => samples[i - 1].Length > 0.0 && samples[i].Length <= 0.0)
                    .Select(i => samples[i - 1].Time +
                        (samples[i].Time - samples[i - 1].Time) * samples[i - 1].Length / (samples[i - 1].Length - samples[i].Length))
                        .ToArray();
                double late = samples.Where(s => s.Time > 0.6 * LambPeriod).Max(s => s.Length);
                string figures =
                    $"falls through 0 at {string.Join(", ", crossings.Select(t => (1e3 * t).ToString("f2")))} ms, Lamb's period " +
                    $"{1e3 * LambPeriod:f2} ms, " +
                    $"longer by {samples[0].Length:f3} at first, {late:f3} a period later";
                Assert.That(crossings.Length, Is.GreaterThanOrEqualTo(2), figures);
                Assert.That(crossings[1] - crossings[0], Is.EqualTo(LambPeriod).Within(8).Percent, figures);
                Assert.That(late, Is.GreaterThan(0.55 * samples[0].Length), figures);
                TestContext.WriteLine(figures);
            }
        }

        [Test]
        public void ACubeBecomesABallOfItsVolume()
        {
            FluidSolverSettings settings = Water(90f);
            FluidParticle[] cube = ParticleSets.Lattice(new Vector3Int(9, 9, 9), Spacing, 0.05f * Spacing, 5);
            double expected = Spacing * Math.Pow(cube.Length * 3.0 / (4.0 * Math.PI), 1.0 / 3.0);
            using (var rig = new StandardRig(settings, cube))
            {
                Settle(rig, 1.4 * LambPeriod);
                FluidParticle[] end = rig.Particles();
                Vector3 centre = Mean(end);
                double radius = Math.Sqrt(5.0 / 3.0 * end.Average(p => (double)(p.Position - centre).sqrMagnitude));
                double farthest = end.Max(p => (p.Position - centre).magnitude) + 0.5 * Spacing;
                string figures = $"radius {radius / expected:f3}, farthest {farthest / expected:f3}, long by {Lengthening(end):f3}";
                Assert.That(radius, Is.EqualTo(expected).Within(5).Percent, figures);
                Assert.That(farthest, Is.LessThan(1.12 * expected), figures);
                Assert.That(Math.Abs(Lengthening(end)), Is.LessThan(0.04), figures);
                TestContext.WriteLine(figures);
            }
        }

        // By the height of the middle of a cap that has the drop's volume.
        // 75 come of 60 degrees, as angles below 80 are coarse, and 87 where the plate has no part in it.
        [TestCase(60f, 23f)]
        [TestCase(130f, 12f)]
        public void ADropOnAPlateHasItsContactAngle(float angle, float within)
        {
            FluidSolverSettings settings = Water(angle);
            float floor = -0.5f * settings.DomainSize.y;
            FluidParticle[] half = Ball().Where(p => p.Position.y > 0f).Select((p, i) =>
                new FluidParticle(p.Position + floor * Vector3.up, Vector3.zero, (uint)i)).ToArray();
            using (var rig = new StandardRig(settings, half))
            {
                Settle(rig, 2.0 * LambPeriod);
                double volume = 0.93 * half.Length * Math.Pow(Spacing, 3.0), found = AngleOf(Mean(rig.Particles()).y - floor, volume);
                Assert.That(found, Is.EqualTo(angle).Within(within));
                TestContext.WriteLine($"{found:f1} degrees of {angle}");
            }
        }

        [Test]
        public void WithoutTensionNothingIsDispatchedForIt()
        {
            FluidRuleInput input = Input(90f);
            input.SurfaceTension = 0f;
            using (var rig = new StandardRig(FluidRules.Derive(input), Ball()))
            {
                rig.Steps(1);
                Assert.That(rig.State.ForceBuffers<TensionBuffers>(), Is.Null);
            }
        }

        // 2.72 mm for water on Earth: coarser particles do not resolve it. Weaker gravity changes nothing, stronger does.
        [TestCase(0.0027f, 9.81f, false, true)]
        [TestCase(0.0028f, 9.81f, false, false)]
        [TestCase(0.0027f, 0f, false, true)]
        [TestCase(0.0028f, 0f, false, false)]
        [TestCase(0.0028f, 1.62f, false, false)]
        [TestCase(0.0013f, 39.24f, false, true)]
        [TestCase(0.0014f, 39.24f, false, false)]
        [TestCase(0.5f, 0f, true, true)]
        [TestCase(0.5f, 9.81f, true, true)]
        public void TensionActsWhereParticlesResolveItOrItIsAskedFor(float spacing, float gravity, bool anySpacing, bool acts)
        {
            FluidRuleInput input = Input(90f);
            input.Gravity = gravity * Vector3.down;
            input.DomainSize = 20f * spacing * Vector3.one;
            input.Spacing = spacing;
            input.TensionAtAnySpacing = anySpacing;
            StandardSettings own = FluidRules.Derive(input).Own<StandardSettings>();
            Assert.That(own.SurfaceTension, Is.EqualTo(acts ? Tension : 0f));
        }

        [Test]
        public void TooFewNeighboursAreRefused()
        {
            FluidRuleInput input = Input(90f);
            input.SupportRatio = 1.9f;
            Assert.That(() => FluidRules.Derive(input),
                Throws.ArgumentException.With.Message.Contains("Support Ratio is 1.9").And.Message.Contains("2 or more"));
        }

        [Test]
        public void TensionLimitsTheStep()
        {
            FluidSolverSettings settings = Water(90f);
            TimeStepAdvice advice = FluidRules.Advise(settings, 0.1);
            Assert.That(advice.SurfaceTension, Is.EqualTo(0.2 * Math.Sqrt(1000.0 * Math.Pow(Spacing, 3.0) / Tension)).Within(0.01).Percent);
            Assert.That(settings.TimeStep, Is.LessThanOrEqualTo(1.0001 * advice.SurfaceTension));
            Assert.That(advice.Limit, Is.EqualTo(TimeStepLimit.SurfaceTension));
            Assert.That(advice.Explain(settings.TimeStep),
                Does.Contain("which the surface tension sets; a quarter of the Surface Tension would allow"));
        }

        // Damped to rest.
        private static void Settle(StandardRig rig, double time)
        {
            double end = rig.Solver.SimulatedTime + time;
            var damping = new DampVelocitiesPass(rig.Shaders);
            float left = Mathf.Exp(-5f * rig.Solver.Settings.TimeStep / (float)LambPeriod);
            while (rig.Solver.SimulatedTime < end)
            {
                GpuTest.Run(cmd =>
                {
                    for (int i = 0; i < 20; i++)
                    {
                        rig.Solver.RecordSteps(cmd, 1);
                        damping.Record(cmd, rig.State, left);
                    }
                    rig.Solver.RecordNeighbourSetup(cmd);
                });
            }
        }

        private static FluidParticle[] Rest(in FluidSolverSettings settings)
        {
            using (var rig = new StandardRig(settings, Ball()))
            {
                Settle(rig, LambPeriod);
                return rig.Particles();
            }
        }

        // θ of a cap of a volume whose middle is that high over the plate.
        private static double AngleOf(double height, double volume)
        {
            double low = 0.05, high = Math.PI - 0.01;
            for (int i = 0; i < 60; i++)
            {
                double middle = 0.5 * (low + high), c = Math.Cos(middle);
                double radius = Math.Pow(volume / (Math.PI / 3.0 * (2.0 + c) * (1.0 - c) * (1.0 - c)), 1.0 / 3.0), top = radius * (1.0 - c);
                double found = top * (4.0 * radius - top) / (4.0 * (3.0 * radius - top));
                if (found > height) high = middle;
                else low = middle;
            }
            return low * 180.0 / Math.PI;
        }

        private static double Lengthening(FluidParticle[] particles)
        {
            Vector3 centre = Mean(particles);
            double along = particles.Sum(p => Square(p.Position.y - centre.y)),
                across = particles.Sum(p => Square(p.Position.x - centre.x) + Square(p.Position.z - centre.z));
            return (along - 0.5 * across) / (along + across);
        }

        private static double Square(double x) => x * x;

        private static Vector3 Mean(FluidParticle[] particles) =>
            particles.Aggregate(Vector3.zero, (sum, p) => sum + p.Position) / particles.Length;

        // On a lattice that is turned against the axes.
        private static FluidParticle[] Ball()
        {
            Quaternion turn = Quaternion.Euler(40f, 25f, 10f);
            return ParticleSets.Lattice(new Vector3Int(14, 14, 14), Spacing, 0f, 1).Where(p => p.Position.magnitude < Radius)
                .Select((p, i) => new FluidParticle(turn * p.Position, Vector3.zero, (uint)i)).ToArray();
        }

        private static FluidSolverSettings Water(float angle) => FluidRules.Derive(Input(angle));

        private static FluidRuleInput Input(float angle)
        {
            FluidRuleInput input = FluidRuleInput.Water;
            input.DomainSize = 6f * Radius * Vector3.one;
            input.Spacing = Spacing;
            input.Gravity = Vector3.zero;
            input.SurfaceTension = Tension;
            input.ContactAngle = angle;
            return input;
        }
    }
}
