using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>
    /// What the gradient correction does in a step, against sums over all pairs in double precision, and what becomes of it.
    /// </summary>
    public sealed class GradientCorrectionTests
    {
        private const float Spacing = 0.05f;
        private const float TimeStep = 1e-4f;

        private static readonly Vector3 Domain = new Vector3(0.4f, 0.5f, 0.35f);

        private static FluidSolverSettings Settings(FluidAxes periodic = FluidAxes.All) =>
            CorrectionReference.Corrected(StandardStateRig.Water(Domain, Spacing, periodic));

        [Test]
        public void TheDensityHasItsOffset([Values(1, 64, 257)] int count, [Values] bool listed)
        {
            FluidSolverSettings settings = Settings(FluidAxes.None);
            using (var rig = new StandardStateRig(settings, count))
            {
                FluidParticle[] particles = rig.FillSorted(ParticleSets.Random(count, Domain, 1f, 3));
                float[] offsets = FillCorrections(rig, count, 2, out _);
                var pass = new StandardDensityPass(rig.Shaders);
                GpuTest.Run(cmd => pass.Record(cmd, rig.State));
                StandardStateRig.Fill(rig.State.Buffers.NewPositions, particles.Select(p => (Vector4)p.Position).ToArray());
                if (listed) GpuTest.Run(cmd => pass.RecordListed(cmd, rig.State, rig.State.Buffers.NewPositions));
                Vector2[] terms = rig.Terms();
                for (int i = 0; i < count; i++)
                {
                    double density = CorrectionReference.Density(settings, particles, i) + offsets[i];
                    double error = 2e-5 * Math.Max(settings.RestDensity, density);
                    Assert.That(terms[i].x, Is.EqualTo(density).Within(error), $"density of {i}");
                    double pressure = settings.SoundSpeed * (double)settings.SoundSpeed * Math.Max(density - settings.RestDensity, 0.0);
                    Assert.That((double)terms[i].y * terms[i].x * terms[i].x,
                        Is.EqualTo(pressure).Within(2.0 * error * settings.SoundSpeed * settings.SoundSpeed), $"pressure of {i}");
                }
            }
        }

        // Every second is compressed by more than a step does, every third only starts to have an offset.
        [Test]
        public void WhatIsHitIsNotCorrectedUntilTheNextSort([Values] bool listed)
        {
            const int count = 257;
            FluidSolverSettings settings = Settings();
            using (var rig = new StandardStateRig(settings, count))
            {
                FluidParticle[] particles = rig.FillSorted(ParticleSets.Random(count, 0.7f * Domain, 1f, 3));
                FillCorrections(rig, count, 2, out _);
                var buffers = rig.State.ForceBuffers<GradientCorrectionBuffers>();
                uint[] words = GpuTest.Read<uint>(buffers.Corrections, 4 * count);
                for (int i = 0; i < count; i++) words[4 * i + 3] = words[4 * i + 3] & ~3u | (i % 3 == 0 ? 1u : 0u);
                buffers.Corrections.SetData(words);
                var pass = new StandardDensityPass(rig.Shaders);
                GpuTest.Run(cmd => pass.Record(cmd, rig.State));
                float[] densities = rig.Terms().Select(t => t.x).ToArray();
                Vector4[] places = particles.Select((p, i) =>
                    StandardStateRig.WithW(p.Position, densities[i] - (i % 2 == 0 ? 0.1f : 0.01f) * settings.RestDensity)).ToArray();
                rig.State.Impact = new Vector2(0.5f, 0.02f * settings.RestDensity);
                StandardStateRig.Fill(listed ? rig.State.Buffers.NewPositions : rig.State.Buffers.PositionTerms, places);
                GpuTest.Run(cmd =>
                {
                    if (listed) pass.RecordListed(cmd, rig.State, rig.State.Buffers.NewPositions);
                    else pass.Record(cmd, rig.State);
                });
                uint[] after = GpuTest.Read<uint>(buffers.Corrections, 4 * count);
                rig.FillList(particles, true);
                buffers.Moments.SetData(Enumerable.Range(0, 6 * count).Select(k => k % 6 < 3 ? 0.8f : 0f).ToArray());
                var inversion = new InvertMomentsPass(rig.Shaders);
                GpuTest.Run(cmd => inversion.Record(cmd, rig.State));
                uint[] inverted = GpuTest.Read<uint>(buffers.Corrections, 4 * count);
                int hits = 0;
                for (int i = 0; i < count; i++)
                {
                    bool isHit = i % 2 == 0 && i % 3 != 0 && densities[i] > 1.001f * settings.RestDensity;
                    hits += isHit ? 1 : 0;
                    if (!isHit && i % 2 == 0 && i % 3 != 0 && densities[i] > 0.999f * settings.RestDensity) continue; // on the border
                    uint[] expected = words.Skip(4 * i).Take(4).ToArray();
                    if (isHit) expected = new[] { 0u, 0u, 0u, expected[3] | 2u };
                    Assert.That(after.Skip(4 * i).Take(4), Is.EqualTo(expected), $"{i}");
                    Assert.That(inverted[4 * i] == 0u, Is.EqualTo(isHit), $"{i} after the sort");
                }
                Assert.That(hits, Is.GreaterThan(20));
            }
        }

        [Test]
        public void ForcesAndOffsetsAreTheSumsOverAllPairs([Values(1, 63, 64, 65, 257)] int count,
            [Values(FluidAxes.None, FluidAxes.All)] FluidAxes periodic, [Values] bool listed)
        {
            FluidSolverSettings settings = Settings(periodic);
            using (var rig = new StandardStateRig(settings, count))
            {
                Vector3 part = periodic == FluidAxes.All ? Domain : 0.8f * Domain;
                FluidParticle[] start = rig.FillSorted(ParticleSets.Random(count, part, 0.5f, 4));
                var random = new System.Random(9);
                double[] density = start.Select(_ => (double)(float)(settings.RestDensity * (0.9 + 0.25 * random.NextDouble()))).ToArray();
                double c2 = settings.SoundSpeed * (double)settings.SoundSpeed;
                double Term(int k) => Math.Max(0.0, c2 * (density[k] - settings.RestDensity)) / (density[k] * density[k]);
                rig.SetTerms(density.Select((d, i) => new Vector2((float)d, (float)Term(i))).ToArray());
                rig.FillList(start, listed);
                float[] offsets = FillCorrections(rig, count, 5, out double[][] corrections);
                Vector4[] end = Move(rig, new FluidStep(TimeStep, TimeStep, false));
                float[] after = Offsets(rig, count);

                double largest = 1.0;
                var expected = new Double3[count];
                for (int i = 0; i < count; i++)
                {
                    expected[i] = CorrectionReference.Acceleration(settings, start, density, corrections, i, TimeStep);
                    largest = Math.Max(largest, expected[i].Length);
                }
                for (int i = 0; i < count; i++)
                {
                    Double3 measured = ((Double3)(Vector3)end[i] - start[i].VelT0) / TimeStep;
                    Assert.That((measured - expected[i]).Length, Is.LessThan(2e-4 * largest + 0.02), $"acceleration of {i}");
                    double offset = CorrectionReference.NextOffset(settings, start, density, i, corrections[i], offsets[i], TimeStep);
                    Assert.That(after[i], Is.EqualTo(offset).Within(2e-5 * settings.RestDensity), $"offset of {i}");
                }
            }
        }

        // Far apart, each goes its way: an offset fades by so much a step, whatever is born, drained or moved to larger buffers beside it.
        [Test]
        public void OffsetsStayWithTheirParticles()
        {
            FluidSolverSettings settings = BodyRig.Water(new Vector3(2f, 2f, 2f), Spacing, 0.4f);
            settings.Gravity = Vector3.zero;
            settings = CorrectionReference.Corrected(settings);
            FluidParticle[] start = ParticleSets.Lattice(new Vector3Int(6, 6, 6), 0.3f, 0f, 1);
            var random = new System.Random(3);
            for (int i = 0; i < start.Length; i++)
            {
                start[i].VelT0 = 0.4f * ParticleSets.RandomVector(random);
                start[i].DensityOffset = 1f + 0.01f * i;
            }
            using (var rig = new StandardRig(settings, start))
            {
                rig.Setup();
                AssertFaded(rig, 0);
                rig.Steps(10);
                AssertFaded(rig, 10);
                ParticleExchange exchange = rig.Solver.Exchange;
                Assert.That(exchange.Counts.TryOpen(out int source));
                Matrix4x4 half = Matrix4x4.TRS(new Vector3(0.5f, 0f, 0f), Quaternion.identity, new Vector3(0.5f, 1f, 1f));
                exchange.SetDrains(new[] { (DrainZone.Box(half), source) });
                for (int i = 0; i < 400; i++)
                {
                    Vector3 place = new Vector3(-0.9f + 0.06f * (i % 20), -0.9f + 0.06f * (i / 20), -0.93f);
                    exchange.Births.Add(place, Vector3.zero, rig.Solver.SimulatedTime, SourceCounts.Added);
                }
                rig.Steps(7);
                Assert.That(rig.Solver.Capacity, Is.GreaterThan(start.Length));
                Assert.That(AssertFaded(rig, 17), Is.InRange(start.Length / 3, 2 * start.Length / 3));
            }

            // How many of the first are left.
            int AssertFaded(StandardRig rig, int steps)
            {
                FluidParticle[] live = rig.Particles().Where(p => !p.IsRemoved && p.Id < start.Length).ToArray();
                double fading = 0.0018 * settings.TimeStep * settings.SoundSpeed / settings.SupportRadius;
                foreach (FluidParticle particle in live)
                {
                    double expected = (1.0 + 0.01 * particle.Id) * Math.Pow(1.0 - fading, steps);
                    Assert.That(particle.DensityOffset, Is.EqualTo(expected).Within(1e-4 * expected), $"{particle.Id} after {steps} steps");
                }
                return live.Length;
            }
        }

        [Test]
        public void MomentumStays()
        {
            FluidSolverSettings settings = BodyRig.Water(new Vector3(1f, 1f, 1f), Spacing, 0.4f);
            settings.Gravity = Vector3.zero;
            settings.Boundaries.Periodic = FluidAxes.All;
            settings = CorrectionReference.Corrected(settings);
            FluidParticle[] start = ParticleSets.Lattice(new Vector3Int(5, 6, 5), Spacing, 0.1f * Spacing, 1);
            for (int i = 0; i < start.Length; i++) start[i].VelT0 = 0.2f * Vector3.Cross(new Vector3(1f, 2f, -1f), start[i].Position);
            using (var rig = new StandardRig(settings, start))
            {
                rig.Steps(1000);
                FluidParticle[] end = rig.Particles();
                Double3 Momentum(FluidParticle[] particles) => particles.Aggregate(Double3.Zero, (sum, p) => sum + p.VelT0);
                double size = end.Sum(p => (double)p.VelT0.magnitude);
                Assert.That(size, Is.GreaterThan(0.1));
                Assert.That((Momentum(end) - Momentum(start)).Length, Is.LessThan(1e-5 * size));
                Assert.That(end.Max(p => p.DensityOffset), Is.GreaterThan(0.01 * settings.RestDensity), "it acts");
            }
        }

        // Shear mixes the arrangement for ever. What the work takes from offsets must not add up: particles would crowd without a pressure.
        [Test]
        public void LiquidThatIsShearedForLongIsNotCrowded()
        {
            var domain = new Vector3(8f, 8f, 8f) * Spacing;
            FluidSolverSettings settings = BodyRig.Water(domain, Spacing, 0.4f);
            settings.Gravity = Vector3.zero;
            settings.Boundaries.Periodic = FluidAxes.All;
            settings = CorrectionReference.Corrected(settings);
            FluidParticle[] now = ParticleSets.Lattice(new Vector3Int(8, 8, 8), Spacing, 0.1f * Spacing, 1);
            for (int part = 0; part < 30; part++)
            {
                for (int i = 0; i < now.Length; i++)
                {
                    now[i].VelT0 = 0.8f * Mathf.Sin(2f * Mathf.PI * now[i].Position.y / domain.y) * Vector3.right;
                }
                using (var rig = new StandardRig(settings, now))
                {
                    rig.Steps(50);
                    now = rig.Particles();
                }
            }
            double offset = now.Average(p => (double)p.DensityOffset) / settings.RestDensity;
            Assert.That(offset, Is.GreaterThan(-0.05), "mean offset over the density at rest");
        }

        [Test]
        public void ItRepeatsToTheBit()
        {
            FluidSolverSettings settings = CorrectionReference.Corrected(BodyRig.Water(Domain, Spacing, 0.3f));
            FluidParticle[] Play()
            {
                using (var rig = new StandardRig(settings, ParticleSets.Lattice(new Vector3Int(7, 6, 6), Spacing, 0.1f * Spacing, 5)))
                {
                    rig.Steps(60);
                    return rig.Particles();
                }
            }
            Assert.That(Play(), Is.EqualTo(Play()));
        }

        // Moments once a sort, and nothing where it does not act, had it ever acted or not.
        [Test]
        public void ItIsFreeWhereItDoesNotAct()
        {
            const int served = 4;
            FluidSolverSettings on = CorrectionReference.Corrected(BodyRig.Water(Domain, Spacing, 0.3f))
                .WithOwn((ref StandardSettings own) => own.StepsPerSort = served);
            FluidSolverSettings off = on.WithOwn((ref StandardSettings own) => own.GradientCorrection = false);
            FluidParticle[] start = ParticleSets.Lattice(new Vector3Int(6, 5, 6), Spacing, 0.05f * Spacing, 1);
            using (StandardRig never = new StandardRig(off, start), once = new StandardRig(on, start), now = new StandardRig(on, start))
            {
                foreach (StandardRig rig in new[] { never, once, now }) rig.Setup();
                Assert.That(once.Solver.GpuBytes, Is.GreaterThan(never.Solver.GpuBytes));
                once.Solver.ApplySettings(off);
                never.Solver.ApplySettings(off); // which finds neighbours anew
                now.Solver.ApplySettings(on);
                long Dispatches(StandardRig rig)
                {
                    rig.Solver.FlowSpeed = 0f;
                    long before = ComputeKernel.DispatchesRecorded;
                    rig.Steps(2 * served);
                    return ComputeKernel.DispatchesRecorded - before;
                }
                long without = Dispatches(never);
                Assert.That(Dispatches(once), Is.EqualTo(without));
                Assert.That(Dispatches(now), Is.EqualTo(without + 4), "two passes a sort");
                Assert.That(once.Particles(), Is.EqualTo(never.Particles()));
                Assert.That(now.Particles(), Is.Not.EqualTo(never.Particles()));
                Assert.That(once.Solver.GpuBytes, Is.EqualTo(never.Solver.GpuBytes));
            }
        }

        private static Vector4[] Move(StandardStateRig rig, FluidStep step)
        {
            var move = new MoveParticlesPass(rig.Shaders);
            GpuTest.Run(cmd => move.Record(cmd, rig.State, step));
            return GpuTest.Read<Vector4>(rig.State.Buffers.NewVelocities, rig.State.ParticleCount);
        }

        // Any corrections and offsets; every fifth offset is not known.
        private static float[] FillCorrections(StandardStateRig rig, int count, int seed, out double[][] corrections)
        {
            var random = new System.Random(seed);
            float[] offsets = Enumerable.Range(0, count)
                .Select(i => i % 5 == 4 ? 0f : (float)(200.0 * random.NextDouble() - 50.0)).ToArray();
            uint[] words = offsets.SelectMany(offset => CorrectionReference
                .Pack(Enumerable.Range(0, 6).Select(_ => random.NextDouble() - 0.5).ToArray()).Append(StandardStateRig.ToBits(offset)))
                .ToArray();
            corrections = Enumerable.Range(0, count).Select(i => CorrectionReference.Unpack(words, 4 * i)).ToArray();
            rig.State.RequireCarried(StandardForces.All);
            rig.State.ForceBuffers<GradientCorrectionBuffers>().Corrections.SetData(words);
            return offsets;
        }

        private static float[] Offsets(StandardStateRig rig, int count)
        {
            uint[] words = GpuTest.Read<uint>(rig.State.ForceBuffers<GradientCorrectionBuffers>().Corrections, 4 * count);
            return Enumerable.Range(0, count).Select(i => StandardStateRig.FromBits(words[4 * i + 3])).ToArray();
        }
    }
}
