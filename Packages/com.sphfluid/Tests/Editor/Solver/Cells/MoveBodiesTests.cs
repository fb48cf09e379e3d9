using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Rigid bodies on the GPU: motion, what the liquid gives them, and what their owners say.</summary>
    public sealed class MoveBodiesTests
    {
        private const float Spacing = 0.04f;

        private static readonly FluidParticle[] FarParticle = { new FluidParticle(new Vector3(0.9f, 0.9f, 0.9f), Vector3.zero, 0u) };

        private static FluidSolverSettings Settings(bool gravity = true)
        {
            FluidSolverSettings settings = BodyRig.Water(2f * Vector3.one, Spacing, 0.4f, 3f);
            if (!gravity) settings.Gravity = Vector3.zero;
            return settings;
        }

        [TestCase(1, 1)]
        [TestCase(3, 7)]
        public void ABodyInTheAirFallsAsALeapfrogDoes(int frames, int steps)
        {
            FluidSolverSettings settings = Settings();
            using (var rig = new FloatingRig(settings, FarParticle))
            {
                FloatingBody body =
                    rig.AddBox(new Vector3(0.3f, 0.2f, 0.1f), 500f, new Vector3(-0.3f, 0.2f, 0.1f), Quaternion.Euler(10f, 20f, 30f));
                for (int frame = 0; frame < frames; frame++) rig.Frame(steps);
                double v = 0.0, y = 0.2, dt = settings.TimeStep;
                for (int step = 0; step < frames * steps; step++)
                {
                    v += settings.Gravity.y * (step == 0 ? 0.5 * dt : dt);
                    y += v * dt;
                }

                FloatingState state = rig.Read(body);
                Assert.That(state.Velocity.y, Is.EqualTo(v).Within(1e-6 + 1e-5 * Math.Abs(v)));
                Assert.That(state.Centre.y, Is.EqualTo(y).Within(1e-6));
                Assert.That(state.Centre.x, Is.EqualTo(-0.3).Within(1e-6));
                Assert.That(Quaternion.Angle(state.Rotation, Quaternion.Euler(10f, 20f, 30f)), Is.LessThan(0.1f));
                Assert.That(state.Impulse, Is.EqualTo(Vector3.zero));
                Assert.That(state.Time, Is.EqualTo(steps * dt).Within(1e-6), "of the last frame");
            }
        }

        [Test]
        public void PushesOfAFrameAreSpreadOverItsSteps()
        {
            using (var rig = new FloatingRig(Settings(false), FarParticle))
            {
                FloatingBody body = rig.AddBox(0.2f * Vector3.one, 500f, Vector3.zero);
                rig.Frame(1);
                body.Push(new Vector3(0.3f, 0f, 0f), Vector3.zero, new Vector3(0f, 0.01f, 0f), new Vector3(0f, 0f, 0.2f));
                rig.Frame(4);
                FloatingState state = rig.Read(body);
                float dt = rig.Solver.Settings.TimeStep;
                Assert.That(state.Velocity.x, Is.EqualTo(0.3f).Within(1e-6f));
                Assert.That(state.Centre.x, Is.EqualTo(0.3f * dt * (1f + 2f + 3f + 4f) / 4f).Within(1e-6f));
                Assert.That(state.Centre.y, Is.EqualTo(0.01f).Within(1e-6f));
                Assert.That(FloatingPose.Turn(state.Rotation).z, Is.EqualTo(0.2f).Within(1e-5f));
                rig.Frame(4);
                Assert.That(rig.Read(body).Velocity.x, Is.EqualTo(0.3f).Within(1e-6f), "once only");
            }
        }

        // By less than 1e-4 rad a step.
        [Test]
        public void ASlowTurnIsATurn()
        {
            using (var rig = new FloatingRig(Settings(false), FarParticle))
            {
                FloatingBody body = rig.AddBox(0.2f * Vector3.one, 500f, Vector3.zero);
                body.AngularVelocity = new Vector3(0f, 0.02f, 0f);
                rig.Frame(200);
                float turn = 200f * rig.Solver.Settings.TimeStep * 0.02f;
                Assert.That(FloatingPose.Turn(rig.Read(body).Rotation).y, Is.EqualTo(turn).Within(1).Percent);
            }
        }

        [Test]
        public void FrozenAxesStayAndFreeOnesTurn()
        {
            using (var rig = new FloatingRig(Settings(), FarParticle))
            {
                FloatingBody body = rig.AddBox(new Vector3(0.2f, 0.3f, 0.4f), 500f, Vector3.zero);
                FloatingMass mass = body.Mass;
                mass.FreeY = Vector3.zero;
                mass.Inertia.x = float.PositiveInfinity;
                body.Mass = mass;
                rig.Frame(1);
                body.Push(new Vector3(0.1f, 0.2f, 0f), new Vector3(1f, 0f, 2f), Vector3.zero, Vector3.zero);
                rig.Frame(5);
                FloatingState state = rig.Read(body);
                Assert.That((state.Velocity - new Vector3(0.1f, 0f, 0f)).magnitude, Is.LessThan(1e-6f));
                Assert.That(state.AngularVelocity.x, Is.EqualTo(0f).Within(1e-3f));
                Assert.That(state.AngularVelocity.z, Is.EqualTo(2f).Within(1e-5f));
            }
        }

        [Test]
        public void ASeedPutsTheBodyElsewhereAndOlderReadingsDoNotCount()
        {
            using (var rig = new FloatingRig(Settings(), FarParticle))
            {
                FloatingBody body = rig.AddBox(0.2f * Vector3.one, 500f, Vector3.zero);
                rig.Frame(3);
                uint epoch = rig.Read(body).Epoch;
                body.Pose = new FloatingPose(new Vector3(0.5f, 0.1f, 0f), Quaternion.Euler(0f, 90f, 0f));
                body.Velocity = new Vector3(0f, 1f, 0f);
                body.Seed();
                Assert.That(body.KnownFrame, Is.EqualTo(-1));
                rig.Frame(1);
                FloatingState state = rig.Read(body);
                Assert.That(state.Epoch, Is.Not.EqualTo(epoch));
                Assert.That(state.Centre.x, Is.EqualTo(0.5f).Within(1e-5f));
                Assert.That(state.Velocity.y, Is.EqualTo(1f).Within(0.2f));
            }
        }

        // One half is struck; the other goes along, as the whole box does that is struck as much, but for the gyroscopic torque, which one
        // body has not.
        [Test]
        public void HalvesThatRestOnEachOtherMoveAsTheWhole()
        {
            Quaternion turn = Quaternion.Euler(10f, 20f, 30f);
            Vector3 half = new Vector3(0.3f, 0.1f, 0.2f), away = new Vector3(0.5f, 0f, 0f), up = turn * new Vector3(0f, 0.05f, 0f);
            Vector3 strike = new Vector3(0.4f, 0.1f, 0.2f), spin = new Vector3(0.5f, 0f, 1f);
            using (var rig = new FloatingRig(Settings(false), FarParticle))
            {
                FloatingBody lower = rig.AddBox(half, 500f, -away - up, turn), alone = rig.AddBox(half, 500f, 0.6f * Vector3.down, turn);
                FloatingBody upper = rig.AddBox(half, 500f, -away + up, turn),
                    whole = rig.AddBox(new Vector3(0.3f, 0.2f, 0.2f), 500f, away, turn);
                (lower.Stack, upper.Stack) = (1, 1);
                rig.Frame(1);
                upper.Push(strike, spin, Vector3.zero, Vector3.zero);
                Vector3 angular = Vector3.Cross(up, upper.Mass.Mass * strike) +
                    turn * Vector3.Scale(upper.Mass.Inertia, Quaternion.Inverse(turn) * spin);
                whole.Push(0.5f * strike, turn * Vector3.Scale(whole.Mass.InverseInertia, Quaternion.Inverse(turn) * angular), Vector3.zero,
                    Vector3.zero);
                for (int frame = 0; frame < 4; frame++) rig.Frame(frame == 0 ? 1 : 3);
                FloatingState expected = rig.Read(whole);
                Assert.That(expected.AngularVelocity.magnitude, Is.GreaterThan(0.5f));
                foreach (FloatingBody body in new[] { lower, upper })
                {
                    FloatingState state = rig.Read(body);
                    Vector3 arm = expected.Rotation * new Vector3(0f, body == upper ? 0.05f : -0.05f, 0f);
                    Assert.That((state.AngularVelocity - expected.AngularVelocity).magnitude, Is.LessThan(2e-3f));
                    Assert.That((state.Velocity - expected.Velocity - Vector3.Cross(expected.AngularVelocity, arm)).magnitude,
                        Is.LessThan(2e-3f));
                    Assert.That((state.Centre + 2f * away - expected.Centre - arm).magnitude, Is.LessThan(1e-4f));
                }

                Assert.That(rig.Read(alone).Velocity, Is.EqualTo(Vector3.zero));
            }
        }

        // Liquid thrown at a box that is free: both exchange what they have, in every substep.
        [TestCase(100f, 0f, 1)]
        [TestCase(1000f, 25f, 3)]
        [TestCase(5000f, 25f, 1)]
        [TestCase(1000f, 25f, 3, true)]
        public void LiquidAndBodyKeepTheirMomentumTogether(float density, float turn, int stepsPerFrame, bool isCorrected = false)
        {
            FluidSolverSettings settings = isCorrected ? CorrectionReference.Corrected(Settings(false)) : Settings(false);
            FluidParticle[] particles =
                FloatingRig.Block(new Vector3Int(6, 7, 8), Spacing, new Vector3(-0.45f, -0.05f, -0.1f), new Vector3(2f, 0f, 0.3f));
            using (var rig = new FloatingRig(settings, particles))
            {
                var size = new Vector3(0.2f, 0.3f, 0.24f);
                FloatingBody body = rig.AddBox(size, density, new Vector3(0.05f, 0f, 0f), Quaternion.Euler(0f, turn, 0.5f * turn));
                rig.Frame(1);
                Totals before = Of(rig, body);
                for (int frame = 0; frame < 90 / stepsPerFrame; frame++) rig.Frame(stepsPerFrame);
                Totals after = Of(rig, body);
                double scale = particles.Length * settings.ParticleMass * 2.0;
                FluidCounters counters = rig.Solver.ReadCountersNow();
                string figures =
                    $"linear {before.Linear} to {after.Linear}, angular {before.Angular} to {after.Angular}, body " +
                    $"{rig.Read(body).Velocity}, contacts {counters.Contacts}, time {rig.Solver.SimulatedTime}";
                Assert.That(rig.Read(body).Velocity.x * body.Mass.Mass, Is.GreaterThan(0.05 * scale), figures);
                Assert.That((after.Linear - before.Linear).magnitude, Is.LessThan(1e-3 * scale), figures);
                // velocities lie half a step behind the places
                Assert.That((after.Angular - before.Angular).magnitude, Is.LessThan(1e-2 * scale * 0.3), figures);
                Assert.That(counters.ImpulseLimits + counters.NonFinite + counters.DomainClamps, Is.Zero, figures);
            }
        }

        // Too fast for the walls to be felt: contact alone stops it.
        [Test]
        public void AShotGivesTheBodyWhatItLoses()
        {
            FluidSolverSettings settings = Settings(false);
            var shot = new FluidParticle(new Vector3(-0.4f, 0.05f, 0.02f), new Vector3(80f, 5f, 0f), 0u);
            using (var rig = new FloatingRig(settings, new[] { shot }))
            {
                FloatingBody body = rig.AddBox(0.3f * Vector3.one, 100f, Vector3.zero);
                Totals before =
                    new Totals(settings.ParticleMass * shot.VelT0, settings.ParticleMass * Vector3.Cross(shot.Position, shot.VelT0));
                rig.Frame(4);
                Totals after = Of(rig, body);
                FluidCounters counters = rig.Solver.ReadCountersNow();
                Assert.That(counters.Contacts, Is.Positive);
                Assert.That(rig.Read(body).Velocity.x * body.Mass.Mass, Is.GreaterThan(0.9f * before.Linear.x));
                Assert.That((after.Linear - before.Linear).magnitude, Is.LessThan(1e-4f * before.Linear.magnitude));
                Assert.That(after.Angular.z, Is.LessThan(0f), "above its centre");
            }
        }

        [Test]
        public void TheSameRunGivesTheSameBits()
        {
            FloatingState Run()
            {
                FluidParticle[] particles =
                    FloatingRig.Block(new Vector3Int(6, 7, 8), Spacing, new Vector3(-0.45f, -0.05f, -0.1f), new Vector3(2f, 0f, 0.3f));
                using (var rig = new FloatingRig(Settings(), particles))
                {
                    FloatingBody body = rig.AddBox(0.25f * Vector3.one, 300f, Vector3.zero);
                    for (int frame = 0; frame < 20; frame++) rig.Frame(5);
                    return rig.Read(body);
                }
            }

            FloatingState a = Run(), b = Run();
            Assert.That(b, Is.EqualTo(a));
            Assert.That(a.Velocity.x, Is.GreaterThan(0.1f));
        }

        private readonly struct Totals
        {
            public Totals(Vector3 linear, Vector3 angular)
            {
                Linear = linear;
                Angular = angular;
            }

            public Vector3 Linear { get; }
            public Vector3 Angular { get; }
        }

        private static Totals Of(FloatingRig rig, FloatingBody body)
        {
            float mass = rig.Solver.Settings.ParticleMass;
            FloatingState state = rig.Read(body);
            Vector3 linear = state.Velocity * body.Mass.Mass, angular = Vector3.Cross(state.Centre, linear);
            angular += state.Rotation * Vector3.Scale(body.Mass.Inertia, Quaternion.Inverse(state.Rotation) * state.AngularVelocity);
            foreach (FluidParticle p in rig.Particles())
            {
                linear += mass * p.VelT0;
                angular += Vector3.Cross(p.Position, mass * p.VelT0);
            }

            return new Totals(linear, angular);
        }
    }
}
