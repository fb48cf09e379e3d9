using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>
    /// MoveParticles on particles that the test sorts and densities that it makes, against sums over all pairs in
    /// double precision.
    /// </summary>
    public sealed class MoveParticlesTests
    {
        private const float Spacing = 0.05f;
        private const float TimeStep = 1e-4f;

        // Of FluidCounters.hlsl.
        private const int DomainClamp = 1, NonFinite = 2, Removed = 8, LeftThroughFace = 13, MaxSpeed = 14;

        private static readonly Vector3 Domain = new Vector3(0.4f, 0.5f, 0.35f);

        [Test]
        public void ForcesAreTheSumsOverAllPairs([Values(1, 63, 64, 65, 257, 1009)] int count,
            [Values(FluidAxes.None, FluidAxes.Y, FluidAxes.All)] FluidAxes periodic, [Values] bool listed)
        {
            FluidSolverSettings settings = Settings(periodic);
            settings.BodyForce = new FluidBodyForce
            {
                Centre = new Vector3(0.1f, 0f, -0.2f),
                RateSquared = periodic == FluidAxes.None ? new Vector3(3f, 0f, 500f) : Vector3.zero,
            };
            using (var rig = new StandardStateRig(settings, count))
            {
                Vector3 part = periodic == FluidAxes.All ? Domain : 0.8f * Domain;
                FluidParticle[] start = rig.FillSorted(ParticleSets.Random(count, part, 0.5f, 4));
                double[] density = FillDensities(rig, start, 9);
                rig.FillList(start, listed);
                const float previous = 0.5f * TimeStep;
                FluidParticle[] end = Move(rig, new FluidStep(TimeStep, previous, false), out Vector4[] places);

                double kick = 0.75 * TimeStep, largest = 1.0, fastest = 0.0;
                var expected = new Double3[count];
                for (int i = 0; i < count; i++)
                {
                    Double3 force = Force(settings, start[i].Position);
                    expected[i] = StandardReference.Acceleration(start, density, i, settings) + force;
                    largest = Math.Max(largest, expected[i].Length);
                }

                for (int i = 0; i < count; i++)
                {
                    Double3 measured = ((Double3)end[i].VelT0 - start[i].VelT0) / kick;
                    double error = (measured - expected[i]).Length;
                    Assert.That(error, Is.LessThan(2e-4 * largest + 0.02), $"acceleration of {i}");
                    Double3 moved = (Double3)end[i].Position - start[i].Position - TimeStep * (Double3)end[i].VelT0;
                    Assert.That(Image(moved, settings).Length, Is.LessThan(2e-7), $"position of {i}");
                    Assert.That(end[i].Id, Is.EqualTo(start[i].Id), $"id of {i}");
                    Assert.That(places[i].w, Is.EqualTo((float)density[i]), $"density of {i}, for the next step");
                    fastest = Math.Max(fastest, end[i].VelT0.magnitude);
                }

                StandardStateRig.AssertCounted(rig.State, places, Enumerable.Range(0, count).ToArray());
                float reported = StandardStateRig.FromBits(rig.Counters()[MaxSpeed]);
                Assert.That(reported, Is.EqualTo(fastest).Within(1e-4).Percent);
            }
        }

        // In a line of memory before and after others, so that lists are odd and even.
        [Test]
        public void ParticlesInOnePlacePartByTheirOrder([Values(2, 3, 4)] int together, [Values] bool listed)
        {
            const int others = 5;
            FluidSolverSettings settings = Settings(FluidAxes.None);
            using (var rig = new StandardStateRig(settings, together + others))
            {
                FluidParticle[] all = ParticleSets.Random(together + others, 0.2f * Domain, 0f, 4);
                for (int i = 0; i < all.Length; i++)
                {
                    all[i].Position = i < together ? Vector3.zero : new Vector3(0.1f, 0.15f, -0.1f) + Vector3.one * (0.1f * Spacing * i);
                }
                FluidParticle[] start = rig.FillSorted(all);
                FillDensities(rig, start, 9);
                rig.FillList(start, listed);
                FluidParticle[] end = Move(rig, new FluidStep(TimeStep, TimeStep, false), out _);
                Vector3 gained = TimeStep * settings.Gravity;
                Vector3[] pushed = Enumerable.Range(0, start.Length).Where(i => start[i].Position == Vector3.zero)
                    .Select(i => end[i].VelT0 - start[i].VelT0 - gained).ToArray();
                Assert.That(pushed.Length, Is.EqualTo(together));
                Assert.That(pushed[0].x, Is.GreaterThan(1e-5f), "the first goes along x");
                Assert.That(pushed.Select(v => v.x), Is.Ordered.Descending.And.Unique);
                Assert.That(pushed.Sum(v => v.x), Is.Zero.Within(1e-4f * pushed[0].x), "momentum");
                Assert.That(pushed.Max(v => Mathf.Abs(v.y) + Mathf.Abs(v.z)), Is.LessThan(1e-6f));
            }
        }

        // u += a dt / 2 of the first step, then by the mean of both steps' lengths: x follows g t² / 2.
        [TestCase(true, 0.5f)]
        [TestCase(false, 0.75f)]
        public void TheFirstKickIsHalfAStep(bool isFirst, float part)
        {
            FluidSolverSettings settings = Settings(FluidAxes.None);
            settings.Gravity = new Vector3(1f, -9f, 3f);
            var step = new FluidStep(TimeStep, 0.5f * TimeStep, isFirst);
            FluidParticle end = MoveOne(settings, Vector3.zero, Vector3.zero, step, out _);
            Vector3 expected = part * TimeStep * settings.Gravity;
            Assert.That((end.VelT0 - expected).magnitude, Is.LessThan(1e-6f * expected.magnitude));
        }

        // Speed towards a face brings a particle to a quarter of dx in front of it, no nearer; along the face it stays.
        [TestCase(0.5f, 0.25f)]
        [TestCase(0.2f, 0.2f)]
        public void SpeedTowardsAFaceIsCutAtTheShell(float distance, float expected)
        {
            for (int face = 0; face < 6; face++)
            {
                FluidSolverSettings settings = Settings(FluidAxes.None);
                int axis = face / 2;
                float side = face % 2 == 0 ? -1f : 1f;
                Vector3 position = Vector3.zero, velocity = new Vector3(30f, 40f, 50f);
                position[axis] = side * (0.5f * Domain[axis] - distance * Spacing);
                velocity[axis] = side * 1000f;
                FluidParticle end = MoveOne(settings, position, velocity, out uint[] counters);
                float left = 0.5f * Domain[axis] - side * end.Position[axis];
                Assert.That(left / Spacing, Is.EqualTo(expected).Within(1e-4), $"face {face}");
                velocity[axis] = side * (distance - expected) * Spacing / TimeStep;
                Assert.That((end.VelT0 - velocity).magnitude, Is.LessThan(1e-2f), $"face {face}");
                Assert.That(counters[DomainClamp], Is.Zero);
            }
        }

        [Test]
        public void BeyondAFaceAParticleIsPutBackAndCounted()
        {
            FluidSolverSettings settings = Settings(FluidAxes.None);
            var beyond = new Vector3(0.1f, 0.5f * Domain.y + 0.01f, 0f);
            FluidParticle end = MoveOne(settings, beyond, new Vector3(1f, 0f, 2f), out uint[] counters);
            Assert.That(end.Position.y, Is.EqualTo(0.5f * Domain.y));
            Assert.That(end.VelT0, Is.EqualTo(new Vector3(1f, 0f, 2f)));
            Assert.That(counters[DomainClamp], Is.EqualTo(1u));
        }

        [TestCase(FluidAxes.X)]
        [TestCase(FluidAxes.All)]
        public void WhatGoesThroughAPeriodicFaceComesInAtTheOpposite(FluidAxes periodic)
        {
            FluidSolverSettings settings = Settings(periodic);
            var position = new Vector3(0.5f * Domain.x - 0.001f, 0.1f, 0f);
            FluidParticle end = MoveOne(settings, position, new Vector3(30f, 0f, 0f), out uint[] counters);
            Assert.That(end.Position.x, Is.EqualTo(-0.5f * Domain.x + 0.002f).Within(1e-6f));
            Assert.That(end.VelT0.x, Is.EqualTo(30f));
            Assert.That(counters[DomainClamp], Is.Zero);
        }

        [TestCase(float.NaN)]
        [TestCase(float.PositiveInfinity)]
        [TestCase(float.NegativeInfinity)]
        public void AVelocityThatIsNoNumberEndsTheMotion(float bad)
        {
            FluidSolverSettings settings = Settings(FluidAxes.None);
            var position = new Vector3(0.1f, 0.05f, -0.1f);
            FluidParticle end = MoveOne(settings, position, new Vector3(1f, bad, 0f), out uint[] counters);
            Assert.That(end.Position, Is.EqualTo(position));
            Assert.That(end.VelT0, Is.EqualTo(Vector3.zero));
            Assert.That(counters[NonFinite], Is.EqualTo(1u));
        }

        // Below zero it would have left.
        [TestCase(float.NaN)]
        [TestCase(-1f)]
        public void ADensityThatCannotBeIsForgottenAndTheParticleStays(float bad)
        {
            FluidSolverSettings settings = Settings(FluidAxes.None);
            settings.Gravity = Vector3.zero;
            using (var rig = new StandardStateRig(settings, 1))
            {
                rig.FillSorted(new[] { new FluidParticle(new Vector3(0.1f, 0.05f, -0.1f), Vector3.zero, 5u) });
                rig.SetTerms(new[] { new Vector2(bad, 0f) });
                rig.State.List.Counts.SetData(new uint[1]);
                Move(rig, new FluidStep(TimeStep, TimeStep, false), out Vector4[] places);
                Assert.That(places[0].w, Is.Zero);
            }
        }

        // Every third stands behind a face that is open, every seventh left before.
        [TestCase(1)]
        [TestCase(64)]
        [TestCase(257)]
        public void ThroughAnOpenFaceParticlesLeave(int count)
        {
            FluidSolverSettings settings = Settings(FluidAxes.None);
            settings.Boundaries.Open = FluidFaces.HighX;
            FluidParticle[] all = ParticleSets.Random(count, 0.5f * Domain, 0.1f, 2);
            for (int i = 0; i < count; i++)
            {
                if (i % 3 == 0) all[i].Position.x = 0.5f * Domain.x + 0.01f;
                all[i].Removed = i % 7 == 6 ? 1f : 0f;
            }

            using (var rig = new StandardStateRig(settings, count))
            {
                FluidParticle[] start = rig.FillSorted(all);
                int live = start.Count(p => !p.IsRemoved);
                rig.SetTerms(new Vector2[count]);
                rig.FillList(start, false);
                FluidParticle[] end = Move(rig, new FluidStep(TimeStep, TimeStep, false), out Vector4[] places);
                float face = 0.5f * Domain.x;
                int[] leave = Enumerable.Range(0, live).Where(i => start[i].Position.x > face).ToArray();
                Assert.That(Enumerable.Range(0, live).Where(i => end[i].IsRemoved), Is.EqualTo(leave));
                Assert.That(rig.Counters()[Removed], Is.Zero, "nothing is drained");
                Assert.That(rig.Counters()[LeftThroughFace], Is.EqualTo((uint)leave.Length));
                StandardStateRig.AssertCounted(rig.State, places, Enumerable.Range(0, live).ToArray());
            }
        }

        // Morris's sum over the mirror image behind a face: (4 pi / d) times the integral of z W(z) from d to R.
        [TestCase(0.4f)]
        [TestCase(1f)]
        [TestCase(1.5f)]
        public void AFaceWithFrictionSlowsParticlesTowardsItsVelocity(float distance)
        {
            FluidSolverSettings settings = Settings(FluidAxes.None);
            settings.Gravity = Vector3.zero;
            settings.Viscosity = 50f;
            settings.Boundaries.Friction = 0.5f;
            settings.Boundaries.LowY = new Vector3(4f, 0f, -1f);
            double d = distance * Spacing;
            Vector3 position = (float)(d - 0.5 * Domain.y) * Vector3.up, velocity = new Vector3(1f, 0f, 2f);
            FluidParticle end = MoveOne(settings, position, velocity, out _);

            const int steps = 4000;
            double radius = settings.SupportRadius, integral = 0.0;
            for (int i = 0; i < steps; i++)
            {
                double z = d + (radius - d) * (i + 0.5) / steps;
                integral += z * StandardReference.Kernel(z, radius) * (radius - d) / steps;
            }

            double viscosity = settings.Boundaries.Friction * settings.Viscosity / settings.RestDensity;
            double rate = viscosity * 4.0 * Math.PI / d * integral;
            Double3 expected = TimeStep * rate * ((Double3)settings.Boundaries.LowY - velocity);
            Assert.That(expected.Length, Is.GreaterThan(1e-6));
            Assert.That(((Double3)end.VelT0 - velocity - expected).Length, Is.LessThan(1e-3 * expected.Length + 5e-7));
        }

        private static FluidSolverSettings Settings(FluidAxes periodic)
        {
            FluidSolverSettings settings = StandardStateRig.Water(Domain, Spacing, periodic);
            settings.Viscosity = 5f;
            return settings;
        }

        private static FluidParticle MoveOne(
            FluidSolverSettings settings, Vector3 position, Vector3 velocity, out uint[] counters)
        {
            settings.Gravity = Vector3.zero;
            return MoveOne(settings, position, velocity, new FluidStep(TimeStep, TimeStep, false), out counters);
        }

        // A particle alone, without pressure.
        private static FluidParticle MoveOne(
            in FluidSolverSettings settings, Vector3 position, Vector3 velocity, in FluidStep step, out uint[] counters)
        {
            using (var rig = new StandardStateRig(settings, 1))
            {
                rig.FillSorted(new[] { new FluidParticle(position, velocity, 5u) });
                rig.SetTerms(new[] { new Vector2(settings.RestDensity, 0f) });
                rig.State.List.Counts.SetData(new uint[1]);
                FluidParticle end = Move(rig, step, out _)[0];
                counters = rig.Counters();
                return end;
            }
        }

        private static FluidParticle[] Move(StandardStateRig rig, FluidStep step, out Vector4[] places)
        {
            int count = rig.State.ParticleCount;
            var pass = new MoveParticlesPass(rig.Shaders);
            GpuTest.Run(cmd => pass.Record(cmd, rig.State, step));
            places = GpuTest.Read<Vector4>(rig.State.Buffers.NewPositions, count);
            Vector4[] velocities = GpuTest.Read<Vector4>(rig.State.Buffers.NewVelocities, count);
            return places.Zip(velocities, (p, v) =>
                new FluidParticle(p, v, StandardStateRig.ToBits(v.w)) { Removed = p.w }).ToArray();
        }

        // Any densities up to 3 % from that at rest, with their pressures.
        private static double[] FillDensities(StandardStateRig rig, FluidParticle[] particles, int seed)
        {
            FluidSolverSettings settings = rig.State.Settings;
            double c2 = settings.SoundSpeed * (double)settings.SoundSpeed;
            var random = new System.Random(seed);
            var density = new double[particles.Length];
            var terms = new Vector2[particles.Length];
            for (int i = 0; i < density.Length; i++)
            {
                density[i] = settings.RestDensity * (0.97 + 0.06 * random.NextDouble());
                double pressure = Math.Max(0.0, c2 * (density[i] - settings.RestDensity));
                terms[i] = new Vector2((float)density[i], (float)(pressure / (density[i] * density[i])));
            }

            rig.SetTerms(terms);
            return density;
        }

        private static Double3 Force(in FluidSolverSettings settings, Vector3 at)
        {
            Vector3 rate = settings.BodyForce.RateSquared;
            Double3 from = (Double3)settings.BodyForce.Centre - at;
            return new Double3(rate.x * from.X, rate.y * from.Y, rate.z * from.Z);
        }

        // The shortest of a displacement's images along periodic axes.
        private static Double3 Image(Double3 d, in FluidSolverSettings settings)
        {
            Vector3 period = settings.PeriodLength;
            double Shortest(double x, double length) => length > 0.0 ? x - length * Math.Round(x / length) : x;
            return new Double3(Shortest(d.X, period.x), Shortest(d.Y, period.y), Shortest(d.Z, period.z));
        }
    }
}
