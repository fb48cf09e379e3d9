using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Liquid that leaves by drains, or to make room for new liquid, against a list of where each particle was.</summary>
    public sealed class DrainParticlesTests
    {
        private const float Spacing = 0.05f;
        private static readonly Vector3 Domain = new Vector3(1f, 0.8f, 0.9f);

        private static FluidSolverSettings Settings()
        {
            FluidSolverSettings settings = BodyRig.Water(Domain, Spacing, 0.4f);
            settings.Gravity = Vector3.zero;
            return settings;
        }

        private static FluidParticle[] Live(StandardRig rig) => rig.Particles().Where(p => !p.IsRemoved).ToArray();

        [Test]
        public void WhoIsInADrainLeavesAndIsCounted([Values(1, 64, 257, 601)] int count, [Values("box", "sphere", "capsule")] string shape)
        {
            Matrix4x4 frame = Matrix4x4.TRS(new Vector3(0.1f, -0.05f, 0.02f), Quaternion.Euler(20f, 40f, 10f),
                shape == "box" ? new Vector3(0.3f, 0.2f, 0.15f) : 0.2f * Vector3.one);
            DrainZone zone = shape == "box" ? DrainZone.Box(frame) : DrainZone.Capsule(frame, shape == "sphere" ? 0f : 0.8f);
            FluidParticle[] start = ParticleSets.Random(count, 0.9f * Domain, 0f, count);
            using (var rig = new StandardRig(Settings(), start))
            {
                ParticleExchange exchange = rig.Solver.Exchange;
                Assert.That(exchange.Counts.TryOpen(out int source));
                exchange.SetDrains(new[] { (zone, source) });
                rig.Steps(1);
                uint[] expected = start.Where(p => !Holds(shape, frame.inverse.MultiplyPoint3x4(p.Position))).Select(p => p.Id).ToArray();
                Assert.That(Live(rig).Select(p => p.Id).OrderBy(id => id), Is.EqualTo(expected));
                exchange.Counts.ReadNow();
                Assert.That(exchange.Counts.Passed(source), Is.EqualTo(count - expected.Length));
                Assert.That(rig.Solver.ReadCountersNow().Removed, Is.EqualTo(count - expected.Length));
                Assert.That(rig.Solver.LiveCount, Is.EqualTo(expected.Length));
                exchange.SetDrains(new (DrainZone, int)[0]);
                rig.Steps(3);
                Assert.That(Live(rig).Length, Is.EqualTo(expected.Length), "a drain that is gone takes nobody");
            }
        }

        private static bool Holds(string shape, Vector3 u)
        {
            if (shape == "box") return Mathf.Abs(u.x) < 1f && Mathf.Abs(u.y) < 1f && Mathf.Abs(u.z) < 1f;
            if (shape == "capsule") u.y -= Mathf.Clamp(u.y, -0.8f, 0.8f);
            return u.sqrMagnitude < 1f;
        }

        // Ids wrap: the last of 2^32 is older than 0.
        [Test]
        public void TheOldestMakePlaceForTheNew([Values(1, 63, 256, 300)] int births, [Values(0u, 0xffffff00u)] uint firstId)
        {
            FluidParticle[] start = ParticleSets.Lattice(new Vector3Int(10, 6, 10), Spacing, 0f, 1);
            var random = new System.Random(births);
            for (int i = 0; i < start.Length; i++)
            {
                int k = random.Next(i + 1);
                (start[i].Position, start[k].Position) = (start[k].Position, start[i].Position);
                start[i].Id = unchecked(firstId + (uint)i);
            }
            using (var rig = new StandardRig(Settings(), start))
            {
                ParticleExchange exchange = rig.Solver.Exchange;
                exchange.Births.NextId = unchecked(firstId + (uint)start.Length);
                exchange.MostParticles = start.Length + 10;
                exchange.Recycles = true;
                var places = ParticleSets.Lattice(new Vector3Int(19, 1, 17), Spacing, 0f, 1).Take(births);
                foreach (FluidParticle place in places)
                {
                    exchange.Births.Add(place.Position + 0.3f * Vector3.up, Vector3.zero, 0.0, SourceCounts.Added);
                }
                rig.Steps(1);
                int gone = System.Math.Max(0, births - 10);
                IEnumerable<uint> expected = Enumerable.Range(gone, start.Length + births - gone).Select(i => unchecked(firstId + (uint)i));
                Assert.That(Live(rig).Select(p => p.Id).OrderBy(id => unchecked(id - firstId)), Is.EqualTo(expected));
                exchange.Counts.ReadNow();
                Assert.That(exchange.Counts.Passed(SourceCounts.Recycled), Is.EqualTo(gone));
                Assert.That(rig.Solver.ReadCountersNow().Refused, Is.Zero);
            }
        }

        [Test]
        public void WhoseTimeIsOverLeavesAndNobodyElse([Values(1, 64, 257, 601)] int count, [Values(0u, 0xffffff80u)] uint firstId)
        {
            FluidParticle[] start = ParticleSets.Random(count, 0.9f * Domain, 0f, count);
            for (int i = 0; i < count; i++) start[i].Id = unchecked(firstId + (uint)i);
            using (var rig = new StandardRig(Settings(), start))
            {
                ParticleExchange exchange = rig.Solver.Exchange;
                exchange.Births.NextId = unchecked(firstId + (uint)count);
                const float step = 1e-4f;
                exchange.Lifetimes.Add(firstId, 1u, 0.5 * step);
                exchange.Lifetimes.Add(unchecked(firstId + 100u), 100u, 0.5 * step); // over the wrap of ids
                exchange.Lifetimes.Add(unchecked(firstId + 300u), 7u, 1.5 * step);
                Step(rig, step);
                int[] expected = Enumerable.Range(0, count).Where(i => i != 0 && (i < 100 || i >= 200)).ToArray();
                if (count < 200) expected = Enumerable.Range(1, count - 1).ToArray(); // the range is not all born, and waits
                Assert.That(Offsets(rig, firstId), Is.EqualTo(expected));
                Step(rig, step);
                if (count > 307) expected = expected.Where(i => i < 300 || i >= 307).ToArray();
                Assert.That(Offsets(rig, firstId), Is.EqualTo(expected));
                Assert.That(rig.Solver.ReadCountersNow().Removed, Is.EqualTo(count - expected.Length));
                Step(rig, step);
                Assert.That(Offsets(rig, firstId), Is.EqualTo(expected));
            }
        }

        private static void Step(StandardRig rig, float length) => GpuTest.Run(cmd =>
        {
            rig.Solver.RecordSteps(cmd, 1, length);
            rig.Solver.RecordNeighbourSetup(cmd);
        });

        private static IEnumerable<int> Offsets(StandardRig rig, uint firstId) =>
            Live(rig).Select(p => (int)unchecked(p.Id - firstId)).OrderBy(i => i);

        [Test]
        public void AFountainKeepsItsNumberAndTwoRunsAreEqual()
        {
            FluidParticle[][] ends = new FluidParticle[2][];
            for (int run = 0; run < 2; run++)
            {
                FluidSolverSettings settings = Settings();
                settings.Gravity = new Vector3(0f, -9.81f, 0f);
                using (var rig = new StandardRig(settings, new FluidParticle[0]))
                {
                    ParticleExchange exchange = rig.Solver.Exchange;
                    exchange.MostParticles = 200;
                    exchange.Recycles = true;
                    Assert.That(exchange.Counts.TryOpen(out int drain));
                    exchange
                        .SetDrains(
                            new[]
                            { (DrainZone.Box(Matrix4x4.TRS(new Vector3(0.4f, -0.35f, 0f), Quaternion.identity,
                                new Vector3(0.1f, 0.1f, 0.4f))), drain) });
                    for (int frame = 0; frame < 60; frame++)
                    {
                        foreach (FluidParticle place in ParticleSets.Lattice(new Vector3Int(3, 1, 3), Spacing, 0f, 1))
                        {
                            exchange.Births.Add(place.Position + 0.3f * Vector3.up, new Vector3(1f, -2f, 0f), rig.Solver.SimulatedTime,
                                SourceCounts.Added);
                        }
                        rig.Solver.FlowSpeed = 2f;
                        rig.Steps(12);
                        if (frame % 7 == 0) rig.Solver.ReadCountersNow(); // at times the CPU knows more
                    }
                    ends[run] = Live(rig);
                    FluidCounters counters = rig.Solver.ReadCountersNow();
                    Assert.That(ends[run].Length, Is.LessThanOrEqualTo(200).And.EqualTo(counters.Born - counters.Removed));
                    Assert.That(counters.Born, Is.GreaterThan(400));
                    Assert.That(rig.Solver.Capacity, Is.LessThan(600), "buffers do not grow for ever");
                    exchange.Counts.ReadNow();
                    Assert.That(exchange.Counts.Passed(drain), Is.GreaterThan(0));
                    Assert.That(exchange.Counts.Passed(drain) + exchange.Counts.Passed(SourceCounts.Recycled),
                        Is.EqualTo(counters.Removed));
                }
            }
            Assert.That(ends[0], Is.EqualTo(ends[1]), "to the last bit");
        }
    }
}
