using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    public sealed class MoveByConstraintsTests
    {
        private const float Spacing = 0.05f;
        private const float TimeStep = 1f / 240f;

        private static readonly Vector3 Domain = new Vector3(0.4f, 0.35f, 0.36f);

        [TestCase(1, FluidAxes.None)]
        [TestCase(63, FluidAxes.All)]
        [TestCase(64, FluidAxes.None)]
        [TestCase(65, FluidAxes.Y)]
        [TestCase(251, FluidAxes.None)]
        public void ChangesOfTheMultipliersMoveAlongTheGradientsAndPairsDrag(int count, FluidAxes periodic)
        {
            FluidSolverSettings settings = RobustStateRig.Robust(Domain, Spacing, periodic);
            settings.Viscosity = 2f;
            using (var rig = new RobustStateRig(settings, count))
            {
                FluidParticle[] particles = Prepared(rig, out Vector4[] terms);
                var pass = new MoveByConstraintsPass(rig.Shaders);
                GpuTest.Run(cmd => pass.Record(cmd, rig.State, TimeStep, 2, true));
                Vector4[] displacements = GpuTest.Read<Vector4>(rig.State.Motion.Displacements, count);
                Vector4[] places = GpuTest.Read<Vector4>(rig.State.Buffers.NewPositions, count);
                for (int i = 0; i < count; i++)
                {
                    Double3 expected = TimeStep * (Double3)particles[i].VelT0 + Moved(particles, terms, i, settings) +
                        TimeStep * TimeStep * Dragged(particles, i, settings);
                    Assert.That(RobustStateRig.ToBits(displacements[i].w), Is.EqualTo(particles[i].Id));
                    Assert.That(places[i].w, Is.EqualTo(terms[i].w), "multiplier");
                    for (int axis = 0; axis < 3; axis++)
                    {
                        if (settings.PeriodLength[axis] == 0f && IsAtShell(places[i][axis], axis)) continue;
                        double component = axis == 0 ? expected.X : axis == 1 ? expected.Y : expected.Z;
                        Assert.That(displacements[i][axis], Is.EqualTo(component).Within(2e-4 * Spacing), $"particle {i}");
                    }
                }
            }
        }

        [Test]
        public void WallsAtRestTakeSpeed()
        {
            const int count = 251;
            Vector4[] Moved(float friction, out FluidParticle[] particles, out float radius)
            {
                FluidSolverSettings settings = RobustStateRig.Robust(Domain, Spacing);
                settings.Viscosity = 2f;
                settings.Boundaries.Friction = friction;
                radius = settings.SupportRadius;
                using (var rig = new RobustStateRig(settings, count))
                {
                    particles = Prepared(rig, out _);
                    rig.SetTerms(new Vector2[count]);
                    var pass = new MoveByConstraintsPass(rig.Shaders);
                    GpuTest.Run(cmd => pass.Record(cmd, rig.State, TimeStep, 2, true));
                    return GpuTest.Read<Vector4>(rig.State.Motion.Displacements, count);
                }
            }
            Vector4[] free = Moved(0f, out FluidParticle[] at, out float reach), held = Moved(1f, out _, out _);
            for (int i = 0; i < count; i++)
            {
                Vector3 change = held[i] - free[i], gap = 0.5f * Domain;
                bool nearFace = Enumerable.Range(0, 3).Any(a => gap[a] - Mathf.Abs(at[i].Position[a]) < reach);
                if (nearFace) Assert.That(Vector3.Dot(change, at[i].VelT0), Is.LessThan(1e-9f), $"particle {i}");
                else Assert.That(change, Is.EqualTo(Vector3.zero), $"particle {i}");
            }
            Assert.That(Enumerable.Range(0, count).Max(i => ((Vector3)(held[i] - free[i])).magnitude), Is.GreaterThan(1e-5f));
        }

        [Test]
        public void LaterIterationsGoOnFromTheLast()
        {
            FluidSolverSettings settings = RobustStateRig.Robust(Domain, Spacing, FluidAxes.All);
            const int count = 129;
            using (var rig = new RobustStateRig(settings, count))
            {
                Prepared(rig, out Vector4[] terms);
                var pass = new MoveByConstraintsPass(rig.Shaders);
                GpuTest.Run(cmd => pass.Record(cmd, rig.State, TimeStep, 2, true));
                Vector4[] Moved() => GpuTest.Read<Vector4>(rig.State.Motion.Displacements, count);
                Vector4[] first = Moved(), at = GpuTest.Read<Vector4>(rig.State.Buffers.NewPositions, count);
                GpuTest.Run(cmd => pass.Record(cmd, rig.State, TimeStep, 2, false));
                Vector4[] second = Moved(), then = GpuTest.Read<Vector4>(rig.State.Buffers.NewPositions, count);
                GpuTest.Run(cmd => pass.Record(cmd, rig.State, TimeStep, 2, false));
                Vector4[] third = Moved();
                for (int i = 0; i < count; i++)
                {
                    Assert.That((third[i] - second[i] - (second[i] - first[i])).magnitude, Is.LessThan(1e-6f),
                        "the same terms move as far again");
                    Assert.That(then[i].w, Is.EqualTo(at[i].w + terms[i].w).Within(1e-9));
                }
            }
        }

        [Test]
        public void NobodyIsBroughtNearerToAFaceThanTheShellOrThePrediction()
        {
            FluidSolverSettings settings = RobustStateRig.Robust(Domain, Spacing);
            const int count = 509;
            using (var rig = new RobustStateRig(settings, count))
            {
                FluidParticle[] particles = Prepared(rig, out _, 1f);
                var pass = new MoveByConstraintsPass(rig.Shaders);
                GpuTest.Run(cmd => pass.Record(cmd, rig.State, TimeStep, 2, true));
                Vector4[] places = GpuTest.Read<Vector4>(rig.State.Buffers.NewPositions, count),
                    moved = GpuTest.Read<Vector4>(rig.State.Motion.Displacements, count);
                Vector4[] starts = GpuTest.Read<Vector4>(rig.State.Motion.Starts, count);
                int held = 0;
                for (int i = 0; i < count; i++)
                    for (int axis = 0; axis < 3; axis++)
                    {
                        float half = 0.5f * Domain[axis], least = Mathf.Min(0.25f * Spacing, half - Mathf.Abs(particles[i].Position[axis]));
                        Assert.That(half - Mathf.Abs(places[i][axis]), Is.GreaterThan(least - 1e-6f), $"particle {i}");
                        Assert.That(starts[i][axis] + moved[i][axis], Is.EqualTo(places[i][axis]).Within(1e-6),
                            "the displacement leads there");
                        held += IsAtShell(places[i][axis], axis) ? 1 : 0;
                    }
                Assert.That(held, Is.GreaterThan(0));
            }
        }

        [Test]
        public void WherePredictionWasHeldTheDisplacementIsWhatWasGone()
        {
            FluidSolverSettings settings = RobustStateRig.Robust(Domain, Spacing, FluidAxes.All);
            const int count = 65;
            using (var rig = new RobustStateRig(settings, count))
            {
                FluidParticle[] particles = Prepared(rig, out _);
                rig.SetTerms(new Vector2[count]);
                var starts = particles.Select(p => RobustStateRig.WithW(p.Position - 0.01f * Vector3.one, 0f)).ToArray();
                rig.State.Motion.Starts.SetData(starts);
                rig.State.Buffers.Velocities
                    .SetData(particles.Select(p => RobustStateRig.WithW(Vector3.right, RobustStateRig.FromBits(p.Id))).ToArray());
                var pass = new MoveByConstraintsPass(rig.Shaders);
                GpuTest.Run(cmd => pass.Record(cmd, rig.State, TimeStep, 2, true));
                foreach (Vector4 displacement in GpuTest.Read<Vector4>(rig.State.Motion.Displacements, count))
                {
                    Assert.That(((Vector3)displacement - 0.01f * Vector3.one).magnitude, Is.LessThan(1e-3f * Spacing));
                }
            }
        }

        [Test]
        public void LongStepsBoundTheViscosity()
        {
            FluidSolverSettings settings = RobustStateRig.Robust(Domain, Spacing);
            settings.Viscosity = 50f * settings.RestDensity;
            double acting = RobustRules.ActingViscosity(settings, TimeStep, 2);
            Assert.That(acting, Is.LessThan(settings.Viscosity));
            Assert.That(RobustRules.ActingViscosity(settings, 0.5 * TimeStep, 4), Is.EqualTo(2.0 * acting).Within(1e-6).Percent);
            Assert.That(RobustRules.ActingViscosity(settings, TimeStep, 16), Is.EqualTo(0.25 * acting).Within(1e-6).Percent);
            const int count = 257;
            using (var rig = new RobustStateRig(settings, count))
            {
                FluidParticle[] particles = Prepared(rig, out _);
                rig.SetTerms(new Vector2[count]);
                var pass = new MoveByConstraintsPass(rig.Shaders);
                GpuTest.Run(cmd => pass.Record(cmd, rig.State, TimeStep, 2, true));
                double before = particles.Sum(p => Double3.Dot(p.VelT0, p.VelT0)),
                    after = GpuTest.Read<Vector4>(rig.State.Motion.Displacements, count)
                    .Sum(u => Double3.Dot((Vector3)u, (Vector3)u) / (TimeStep * (double)TimeStep));
                Assert.That(after, Is.LessThan(before), "viscosity takes energy, however large it is");
            }
        }

        private static bool IsAtShell(float x, int axis) => Mathf.Abs(x) > 0.5f * Domain[axis] - 0.251f * Spacing;

        // Particles where they were predicted, and where they began.
        private static FluidParticle[] Prepared(RobustStateRig rig, out Vector4[] terms, float part = 0.9f)
        {
            FluidParticle[] particles = part == 0.9f ? rig.Constrained(TimeStep) : Full(rig);
            rig.State.Motion.Starts.SetData(particles.Select(p => RobustStateRig.WithW(p.Position - TimeStep * p.VelT0, 0f)).ToArray());
            terms = GpuTest.Read<Vector4>(rig.State.Buffers.PositionTerms, particles.Length);
            return particles;
        }

        private static FluidParticle[] Full(RobustStateRig rig)
        {
            FluidParticle[] particles = rig.FillSorted(ParticleSets.Random(rig.State.ParticleCount, Domain, 1f, 5));
            var pass = new ConstrainDensityPass(rig.Shaders);
            GpuTest.Run(cmd => pass.Record(cmd, rig.State, RobustRules.Compliance(rig.State.Settings, TimeStep, TimeStep, 1)));
            return particles;
        }

        private static Double3 Dragged(FluidParticle[] particles, int i, FluidSolverSettings settings)
        {
            float sound = (float)Math.Min(settings.SoundSpeed, RobustRules.EffectiveSoundSpeed(settings, TimeStep, 2));
            double density = settings.RestDensity, factor = 2.0 * RobustRules.ActingViscosity(settings, TimeStep, 2) / (density * density) *
                settings.ParticleMass / StandardReference.Response(settings);
            var sum = new Double3();
            for (int j = 0; j < particles.Length; j++)
            {
                Double3 d = ThesisReference.Separation(particles[i], particles[j], settings.PeriodLength),
                    relative = particles[i].VelT0 - particles[j].VelT0;
                if (j == i || d.Length >= settings.SupportRadius) continue;
                sum += factor * StandardReference.Slope(d.Length, settings.SupportRadius) / d.Length * relative;
                sum += StandardReference.Parting(d, relative, settings.WithSoundSpeed(sound));
            }
            return sum;
        }

        private static Double3 Moved(FluidParticle[] particles, Vector4[] terms, int i, FluidSolverSettings settings)
        {
            double response = StandardReference.Response(settings), ratio = settings.ParticleMass / (settings.RestDensity * response),
                h = 1e-4 * Spacing;
            double Walls(double x, double y, double z) =>
                StandardReference.Walls((Double3)particles[i].Position + new Double3(x, y, z), settings);
            Double3 moved = terms[i].w / (2.0 * h * response) *
                new Double3(Walls(h, 0, 0) - Walls(-h, 0, 0), Walls(0, h, 0) - Walls(0, -h, 0), Walls(0, 0, h) - Walls(0, 0, -h));
            for (int j = 0; j < particles.Length; j++)
            {
                Double3 d = ThesisReference.Separation(particles[i], particles[j], settings.PeriodLength);
                if (j == i || d.Length >= settings.SupportRadius) continue;
                moved += (terms[i].w + (double)terms[j].w) * ratio * StandardReference.Slope(d.Length, settings.SupportRadius) /
                    d.Length * d;
            }
            return moved;
        }
    }
}
