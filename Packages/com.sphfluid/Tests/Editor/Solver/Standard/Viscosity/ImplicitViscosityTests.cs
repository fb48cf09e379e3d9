using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Thick liquids at steps that an explicit viscosity would not survive.</summary>
    public sealed class ImplicitViscosityTests
    {
        [Test]
        public void TheRuleTakesTheCheaperOfBoth()
        {
            // dx = 25 mm, a fall of 1 m: c = 22.15 m/s, steps of 1.42 ms, and 0.035 M R²/ν is half of that at 0.15 m²/s.
            FluidSolverSettings thin = Rules(0.14f), thick = Rules(0.16f);
            Assert.That(thin.Own<StandardSettings>().ImplicitViscosity, Is.False);
            Assert.That(thick.Own<StandardSettings>().ImplicitViscosity, Is.True);
            float water = Rules(1e-6f).TimeStep;
            Assert.That(thin.TimeStep, Is.LessThan(0.56f * water));
            Assert.That(thick.TimeStep, Is.EqualTo(water));
            TimeStepAdvice advice = FluidRules.Advise(thick, thick.MaxSpeed);
            Assert.That(advice.Limit, Is.EqualTo(TimeStepLimit.Acoustic));
            Assert.That(advice.Explain(thick.TimeStep),
                Does.EndWith(" The kinematic viscosity (0.16 m²/s) is implicit and sets no limit."));
        }

        // A fixed step is taken as it is: what it is too long for is solved.
        [Test]
        public void AFixedStepChoosesByItself()
        {
            FluidRuleInput input = Input(0.1f);
            double border = 0.035 * 0.97628 * 0.05625 * 0.05625 / 0.1;
            input.FixedTimeStep = (float)(0.99 * border);
            Assert.That(FluidRules.Derive(input).Own<StandardSettings>().ImplicitViscosity, Is.False);
            input.FixedTimeStep = (float)(1.01 * border);
            Assert.That(FluidRules.Derive(input).Own<StandardSettings>().ImplicitViscosity, Is.True);
        }

        [Test]
        public void TheStepIsNeverLongerThanTheIterationsSolve()
        {
            FluidSolverSettings pitch = Rules(1000f);
            TimeStepAdvice advice = FluidRules.Advise(pitch, pitch.MaxSpeed);
            Assert.That(advice.Limit, Is.EqualTo(TimeStepLimit.Viscosity));
            Assert.That(pitch.TimeStep, Is.EqualTo(advice.Viscosity).Within(1e-4).Percent);
            Assert.That(ImplicitViscosity.Iterations(pitch, pitch.TimeStep),
                Is.InRange(ImplicitViscosity.MostIterations - 1, ImplicitViscosity.MostIterations));
            Assert.That(ImplicitViscosity.Iterations(pitch, 0.25 * pitch.TimeStep), Is.InRange(32, 34), "they go with the root");
        }

        // Walls 0.3 m apart, driven by a force: u = F y (L - y)/2 nu, at 20 times the explicit border.
        [Test]
        public void AChannelsFlowIsAParabola()
        {
            const float kinematic = 10f;
            const int layers = 12, width = 7;
            const float spacing = 0.025f, gap = layers * spacing, fastest = 0.2f;
            float force = 8f * kinematic * fastest / (gap * gap);
            FluidRuleInput input = Input(kinematic);
            input.DomainSize = new Vector3(width, layers, width) * spacing;
            input.LiquidHeight = input.LiquidDepth = 0f;
            input.Gravity = force * Vector3.right;
            input.MinSpeed = 1f;
            FluidSolverSettings settings = FluidRules.Derive(input);
            settings.Boundaries = new FluidBoundaries { Periodic = FluidAxes.X | FluidAxes.Z, NoSlip = true };
            FluidParticle[] start = ParticleSets.Lattice(new Vector3Int(width, layers, width), spacing, 0f, 1);
            using (var rig = new StandardRig(settings, start))
            {
                double border = 0.072 * settings.SupportRadius * settings.SupportRadius / kinematic;
                Assert.That(settings.TimeStep, Is.GreaterThan(20.0 * border), "the step is far beyond the explicit border");
                int steps = (int)Math.Ceiling(0.5 * gap * gap / kinematic / settings.TimeStep) + 20; // of the slowest mode e^-5
                rig.Steps(steps);
                double square = 0.0, of = 0.0;
                foreach (FluidParticle p in rig.Particles())
                {
                    double y = p.Position.y + 0.5 * gap, exact = 4.0 * fastest * y * (gap - y) / (gap * gap);
                    square += (p.VelT0.x - exact) * (p.VelT0.x - exact);
                    of += exact * exact;
                }
                Assert.That(Math.Sqrt(square / of), Is.LessThan(0.02),
                    $"{steps} steps of {settings.TimeStep} s, {ImplicitViscosity.Iterations(settings, settings.TimeStep)} iterations");
            }
        }

        // Where both hold, they are two discretisations of the same flow: they differ in the first order of the step.
        [Test]
        public void AtAShortStepItIsTheExplicitOne()
        {
            FluidSolverSettings settings = Rules(0.05f);
            settings.Gravity = Vector3.zero;
            FluidParticle[] start = Blob(9);
            for (int i = 0; i < start.Length; i++) start[i].VelT0 = new Vector3(Mathf.Sin(8f * start[i].Position.y), 0f, 0f);
            settings.TimeStep *= 0.02f;
            FluidParticle[] plain = Run(settings, start, 50), solved = Run(Implicit(settings), start, 50);
            double change = plain.Zip(start.OrderBy(p => p.Id), (a, b) => (double)(a.VelT0 - b.VelT0).sqrMagnitude).Sum();
            double apart = plain.Zip(solved, (a, b) => (double)(a.VelT0 - b.VelT0).sqrMagnitude).Sum();
            Assert.That(Math.Sqrt(apart / change), Is.LessThan(0.03));
        }

        // Free fall of a blob that turns: momentum is that of the fall.
        [Test]
        public void AThickDropFallsWithItsMomentum()
        {
            FluidSolverSettings settings = Rules(2f);
            Assert.That(settings.Own<StandardSettings>().ImplicitViscosity, Is.True);
            FluidParticle[] start = Blob(9);
            for (int i = 0; i < start.Length; i++)
            {
                start[i].VelT0 = new Vector3(0.4f - 2f * start[i].Position.z, 0.3f, 3f * start[i].Position.x);
            }
            const int steps = 40;
            FluidParticle[] end = Run(settings, start, steps);
            Double3 Mean(IEnumerable<FluidParticle> all) => all.Aggregate(Double3.Zero, (sum, p) => sum + p.VelT0) / start.Length;
            Double3 expected = Mean(start) + (steps - 0.5) * settings.TimeStep * (Double3)settings.Gravity;
            Assert.That((Mean(end) - expected).Length, Is.LessThan(1e-5 * expected.Length));
        }

        // A column of a thick liquid on a floor that holds it slumps slowly, and stays in one piece.
        [Test]
        public void AThickColumnSlumpsAndStaysWhole()
        {
            FluidRuleInput input = Input(3f);
            input.DomainSize = new Vector3(1f, 0.5f, 1f);
            input.LiquidHeight = input.LiquidDepth = 0.4f;
            FluidSolverSettings settings = FluidRules.Derive(input);
            settings.Boundaries.NoSlip = true;
            FluidParticle[] start = ParticleSets.Lattice(new Vector3Int(7, 12, 7), 0.025f, 0.001f, 3);
            for (int i = 0; i < start.Length; i++) start[i].Position.y -= 0.25f - 6f * 0.025f;
            using (var rig = new StandardRig(settings, start))
            {
                rig.Steps((int)Math.Ceiling(0.2 / settings.TimeStep));
                FluidParticle[] end = rig.Particles();
                float top = end.Max(p => p.Position.y) + 0.25f,
                    spread = end.Max(p => Mathf.Max(Mathf.Abs(p.Position.x), Mathf.Abs(p.Position.z)));
                string figures = $"top {top:f3} m, spread {spread:f3} m, fastest {end.Max(p => p.VelT0.magnitude):f3} m/s";
                Assert.That(top, Is.InRange(0.2f, 0.28f), figures);
                Assert.That(spread, Is.InRange(0.077f, 0.1f), figures);
                Assert.That(end.Max(p => p.VelT0.magnitude), Is.LessThan(0.5f), figures);
                Assert.That(rig.Solver.ReadCountersNow().NonFinite, Is.Zero);
            }
        }

        // Particles that feel nothing but a triangle: v = v0 / (1 + dt rate), and moving walls take along what they hold.
        [TestCase(0f)]
        [TestCase(2f)]
        public void AMeshHoldsLiquidHoweverLongTheStep(float wallSpeed)
        {
            FluidSolverSettings settings = Implicit(BodyRig.Water(Vector3.one, 0.02f, 0.1f));
            settings.Gravity = Vector3.zero;
            settings.Viscosity = 5f * settings.RestDensity;
            settings.Boundaries.Friction = 1f;
            using (var rig = new BodyRig(settings))
            {
                Vector3 a = new Vector3(-1f, 0f, -1f), b = new Vector3(-1f, 0f, 1f), c = new Vector3(1f, 0f, 1f),
                    d = new Vector3(1f, 0f, -1f);
                Transform plate = rig.Add(new[] { a, b, c, a, c, d });
                FluidParticle[] start = Enumerable.Range(0, 65).Select(i => new FluidParticle(
                    new Vector3(0.06f * (i % 10 - 4.5f), settings.SupportRadius * (0.15f + 0.012f * i), 0.06f * (i / 10 - 4.5f)),
                    new Vector3(1f, 0f, -0.3f), (uint)i)).ToArray();
                rig.Start(start);
                plate.position += wallSpeed * settings.TimeStep * Vector3.right;
                rig.Frame(1);
                foreach (FluidParticle p in rig.Particles())
                {
                    double q = start[(int)p.Id].Position.y / settings.SupportRadius, u = Math.Max(0.0, 1.0 - q);
                    double drag = 42.0 * Math.Pow(u, 5.0) * (1.0 - 1.5 * u + 4.0 / 7.0 * u * u) /
                        (q * settings.SupportRadius * settings.SupportRadius);
                    double taken = 0.5 * settings.TimeStep * 5.0 * drag; // the first kick is half a step's
                    Assert.That(p.VelT0.x, Is.EqualTo((1.0 + taken * wallSpeed) / (1.0 + taken))
                        .Within(0.03 * Math.Max(1.0, Math.Abs(wallSpeed - 1.0))), $"at {q:f2} R, {taken:f2}");
                }
            }
        }

        private static FluidParticle[] Run(in FluidSolverSettings settings, FluidParticle[] start, int steps)
        {
            using (var rig = new StandardRig(settings, start))
            {
                rig.Steps(steps);
                return rig.Particles().OrderBy(p => p.Id).ToArray();
            }
        }

        private static FluidSolverSettings Implicit(in FluidSolverSettings settings) =>
            settings.WithOwn((ref StandardSettings own) => own.ImplicitViscosity = true);

        private static FluidParticle[] Blob(int side) => ParticleSets.Lattice(new Vector3Int(side, side, side), 0.025f, 0.001f, 2);

        private static FluidSolverSettings Rules(float kinematic) => FluidRules.Derive(Input(kinematic));

        private static FluidRuleInput Input(float kinematic)
        {
            FluidRuleInput input = FluidRuleInput.Water;
            input.DomainSize = new Vector3(1f, 1f, 1f);
            input.Spacing = 0.025f;
            input.LiquidHeight = input.LiquidDepth = 1f;
            input.KinematicViscosity = kinematic;
            return input;
        }
    }
}
