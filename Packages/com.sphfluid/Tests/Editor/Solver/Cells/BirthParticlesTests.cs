using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Particles that are born into a running liquid, against a list of where each particle is.</summary>
    public sealed class BirthParticlesTests
    {
        private const float Spacing = 0.05f;
        private static readonly Vector3 Domain = new Vector3(1.2f, 1f, 0.9f);

        private static FluidSolverSettings Settings(FluidAxes periodic = FluidAxes.None)
        {
            FluidSolverSettings settings = BodyRig.Water(Domain, Spacing, 0.4f);
            settings.Gravity = Vector3.zero;
            settings.Boundaries.Periodic = periodic;
            return settings;
        }

        // Places on a lattice, so that none is in another's way.
        private static List<Vector3> Sites(int count) =>
            ParticleSets.Lattice(new Vector3Int(11, 11, 11), Spacing, 0f, 1).Select(p => p.Position).Take(count).ToList();

        private static void Add(FluidSolver solver, IEnumerable<Vector3> places, Vector3 velocity, int source = SourceCounts.Added)
        {
            foreach (Vector3 place in places) solver.Exchange.Births.Add(place, velocity, solver.SimulatedTime, source);
        }

        private static FluidParticle[] Live(StandardRig rig) => rig.Particles().Where(p => !p.IsRemoved).ToArray();

        [Test]
        public void AnEmptyLiquidFills([Values(1, 63, 64, 65, 257, 1009)] int count,
            [Values(FluidAxes.None, FluidAxes.X)] FluidAxes periodic)
        {
            FluidSolverSettings settings = Settings(periodic);
            using (var rig = new StandardRig(settings, new FluidParticle[0]))
            {
                Assert.That(Live(rig), Is.Empty);
                rig.Steps(2);
                Assert.That(Live(rig), Is.Empty);
                List<Vector3> sites = Sites(count);
                Add(rig.Solver, sites, Vector3.zero);
                rig.Steps(1);
                FluidParticle[] live = Live(rig);
                Assert.That(rig.Solver.ReadCountersNow().Born, Is.EqualTo(count));
                Assert.That(rig.Solver.LiveCount, Is.EqualTo(count));
                Assert.That(live.Select(p => p.Id).OrderBy(id => id), Is.EqualTo(Enumerable.Range(0, count).Select(i => (uint)i)));
                foreach (FluidParticle particle in live)
                {
                    Assert.That((particle.Position - sites[(int)particle.Id]).magnitude, Is.LessThan(1e-6f), $"place of {particle.Id}");
                }
                for (int i = 0; i < live.Length; i += 37)
                {
                    Assert.That(rig.Densities()[i], Is.EqualTo(StandardReference.Density(live, i, settings)).Within(2e-3).Percent,
                        $"density {i}");
                }
                rig.Steps(20);
                Assert.That(Live(rig).Length, Is.EqualTo(count), "nobody is lost");
                Assert.That(rig.Solver.ReadCountersNow().NonFinite, Is.Zero);
            }
        }

        // Against brute force over the particles where the step leaves them.
        [Test]
        public void WhoeverHasNoPlaceIsNotBornAndIsCounted([Values(1, 7)] int seed,
            [Values(FluidAxes.None, FluidAxes.Z)] FluidAxes periodic)
        {
            FluidSolverSettings settings = Settings(periodic);
            FluidParticle[] start = ParticleSets.Lattice(new Vector3Int(8, 8, 8), Spacing, 0f, 1);
            using (var rig = new StandardRig(settings, start))
            {
                rig.Steps(3);
                FluidParticle[] before = Live(rig);
                List<Vector3> places = ParticleSets.Random(400, 1.1f * Domain, 0f, seed).Select(p => p.Position).ToList();
                foreach (Vector3 place in places)
                {
                    rig.Solver.Exchange.Births.Add(place, Vector3.zero, rig.Solver.SimulatedTime, 2 + places.IndexOf(place) % 200);
                }
                rig.Steps(1);
                FluidParticle[] after = Live(rig);
                FluidCounters counters = rig.Solver.ReadCountersNow();
                Assert.That(counters.Born + counters.Blocked, Is.EqualTo(places.Count));
                Assert.That(counters.Born, Is.GreaterThan(20).And.LessThan(places.Count - 20), "both happen");
                Assert.That(after.Length, Is.EqualTo(before.Length + counters.Born));
                var born = new HashSet<uint>(after.Where(p => p.Id >= start.Length).Select(p => p.Id - (uint)start.Length));
                Dictionary<uint, Vector3> old = after.Where(p => p.Id < start.Length).ToDictionary(p => p.Id, p => p.Position);
                for (int i = 0; i < places.Count; i++)
                {
                    float nearest = old.Values.Min(p => Apart(places[i], p, settings));
                    for (int k = 0; k < i; k++)
                        if (k % 200 != i % 200) nearest = Mathf.Min(nearest, Apart(places[i], places[k], settings));
                    bool inside = IsInside(places[i], settings);
                    if (Mathf.Abs(nearest - 0.9f * Spacing) < 1e-5f) continue;
                    Assert.That(born.Contains((uint)i), Is.EqualTo(inside && nearest > 0.9f * Spacing), $"{places[i]}, nearest {nearest}");
                }
            }
        }

        private static float Apart(Vector3 a, Vector3 b, in FluidSolverSettings settings)
        {
            Vector3 d = a - b;
            for (int axis = 0; axis < 3; axis++)
                if (settings.PeriodLength[axis] > 0f) d[axis] -= Domain[axis] * Mathf.Round(d[axis] / Domain[axis]);
            return d.magnitude;
        }

        private static bool IsInside(Vector3 p, in FluidSolverSettings settings)
        {
            for (int axis = 0; axis < 3; axis++)
                if (!(settings.PeriodLength[axis] > 0f) && Mathf.Abs(p[axis]) > 0.5f * Domain[axis]) return false;
            return true;
        }

        // Of the step before: unknown, of a thin gas, or of water; and -1 of those that left, which stay gone.
        [Test]
        public void WhoseDensityABirthChangesForgetsTheOneBefore([Values(1, 3, 65)] int births, [Values(0, 30)] int blocked)
        {
            const int count = 257;
            FluidSolverSettings settings = StandardStateRig.Water(Domain, Spacing);
            float Before(int i) => i % 5 == 0 ? -1f : i % 5 == 1 ? 0f : i % 5 == 2 ? 0.3f : 1000f;
            int slots = count + births + blocked;
            using (var rig = new StandardStateRig(settings, slots))
            using (GraphicsBuffer born = GpuBuffers.Create("Births", births + blocked, ParticleBirth.Stride),
                counts = GpuBuffers.Create("Counts", 3, sizeof(uint)))
            {
                FluidParticle[] all = ParticleSets.Random(slots, 0.9f * Domain, 0f, 3);
                for (int i = count; i < all.Length; i++) all[i].Removed = 1f;
                Vector3[] at = rig.FillSorted(all).Take(count).Select(p => p.Position).ToArray();
                StandardStateRig.Fill(rig.State.Buffers.NewPositions, at.Select((p, i) => StandardStateRig.WithW(p, Before(i))).ToArray());
                Vector3[] places = ParticleSets.Random(2000, 0.9f * Domain, 0f, 4).Select(p => p.Position)
                    .Where(p => at.Min(other => Apart(p, other, settings)) / Spacing is float nearest && nearest > 1f && nearest < 1.5f)
                    .Take(births).ToArray();
                IEnumerable<Vector3> inLiquid = Enumerable.Range(0, count).Where(i => Before(i) >= 0f)
                    .Select(i => at[i] + 0.2f * Spacing * Vector3.up).Take(blocked);
                born.SetData(places.Concat(inLiquid).Select((p, i) => new ParticleBirth { Position = p, Id = (uint)(count + i) })
                    .ToArray());
                counts.SetData(new uint[3]);
                GpuTest.Run(cmd => new BirthParticlesPass(rig.Shaders).Record(cmd, rig.State,
                    new BirthBatch(born, counts, births + blocked, slots, false)));
                Assert.That(GpuTest.Read<uint>(counts, 3), Is.EqualTo(new[] { (uint)births, (uint)blocked, 0u }));
                Vector4[] after = GpuTest.Read<Vector4>(rig.State.Buffers.NewPositions, count);
                int forgot = 0;
                for (int i = 0; i < count; i++)
                {
                    float nearest = places.Min(p => Apart(p, at[i], settings));
                    if (Mathf.Abs(nearest - settings.SupportRadius) < 1e-5f) continue;
                    bool forgets = nearest < settings.SupportRadius && Before(i) > 0f;
                    Assert.That(after[i], Is.EqualTo(StandardStateRig.WithW(at[i], forgets ? 0f : Before(i))),
                        $"particle {i}, {nearest} m from a birth");
                    if (forgets) forgot++;
                }
                Assert.That(forgot, Is.Positive.And.LessThan(count / 2));
            }
        }

        [Test]
        public void BuffersGrowByWhatIsBornAndNothingElseChanges([Values] bool stable)
        {
            FluidSolverSettings settings = Settings().WithOwn((ref StandardSettings own) => own.StableOrder = stable);
            settings.Gravity = new Vector3(0f, -9.81f, 0f);
            FluidParticle[] start = ParticleSets.Lattice(new Vector3Int(6, 5, 4), Spacing, 0.02f * Spacing, 3);
            FluidParticle[][] ends = new FluidParticle[2][];
            for (int roomy = 0; roomy < 2; roomy++)
            {
                using (var rig = new StandardRig(settings, start))
                {
                    if (roomy == 1) ((IExchangingStepper)rig.Solver.Stepper).Reserve(null, 5000);
                    rig.Solver.SetParticles(start);
                    Assert.That(rig.Solver.Capacity, Is.EqualTo(roomy == 1 ? 5000 : start.Length));
                    for (int frame = 0; frame < 12; frame++)
                    {
                        IEnumerable<Vector3> layer = Sites(49).Select(p => new Vector3(p.x, 0.42f, p.z + 0.1f));
                        Add(rig.Solver, layer.Distinct(), new Vector3(0f, -1f, 0f));
                        rig.Steps(30);
                    }
                    ends[roomy] = Live(rig);
                    Assert.That(ends[roomy].Length, Is.GreaterThan(start.Length + 50));
                    Assert.That(rig.Solver.Capacity, Is.GreaterThanOrEqualTo(ends[roomy].Length));
                }
            }
            if (stable) Assert.That(ends[0], Is.EqualTo(ends[1]), "to the last bit");
            else Assert.That(ends[0].Select(p => p.Id).OrderBy(id => id), Is.EqualTo(ends[1].Select(p => p.Id).OrderBy(id => id)));
        }

        [Test]
        public void WhatExceedsTheLimitIsRefusedAndCounted()
        {
            using (var rig = new StandardRig(Settings(), new FluidParticle[0]))
            {
                rig.Solver.Exchange.MostParticles = 100;
                Add(rig.Solver, Sites(257), Vector3.zero);
                rig.Steps(1);
                FluidCounters counters = rig.Solver.ReadCountersNow();
                Assert.That((counters.Born, counters.Refused, counters.Blocked), Is.EqualTo((100L, 157L, 0L)));
                Assert.That(Live(rig).Length, Is.EqualTo(100));
                Assert.That(rig.Solver.Capacity, Is.LessThanOrEqualTo(100));
                rig.Solver.Exchange.Counts.ReadNow();
                Assert.That(rig.Solver.Exchange.Counts.Passed(SourceCounts.Added), Is.EqualTo(100));
                Assert.That(rig.Solver.Exchange.Counts.Refused(SourceCounts.Added), Is.EqualTo(157));
            }
        }

        // Worked example: born 0.01 s before the end of a step, at 2 m/s upwards, it is 2 * 0.01 - 9.81 * 0.01^2 / 2 m higher.
        [Test]
        public void WhoIsBornWithinAStepHasFallenSince()
        {
            var queue = new BirthQueue(7u);
            Vector3 gravity = new Vector3(0f, -9.81f, 0f), velocity = new Vector3(0f, 2f, 0f);
            queue.Add(Vector3.zero, velocity, 1.0, 1);
            queue.Add(Vector3.zero, velocity, 1.02, 1);
            Assert.That(queue.CollectDue(1.01, 0.004f, gravity), Is.EqualTo(1));
            Assert.That(queue.Due[0].Position.y, Is.EqualTo(2.0 * 0.01 - 0.5 * 9.81 * 0.01 * 0.01).Within(1e-6));
            Assert.That(queue.Due[0].Velocity.y, Is.EqualTo(2.0 - 9.81 * (0.01 - 0.002)).Within(1e-5));
            Assert.That((queue.Due[0].Id, queue.Waiting, queue.Taken), Is.EqualTo((7u, 1, 1L)));
            queue.Cancel(1);
            Assert.That((queue.Waiting, queue.NextId), Is.EqualTo((0, 9u)));
        }

        [Test]
        public void ManyBirthsOfOneSourceComeAtOnceAndOfSeveralByAndBy()
        {
            var queue = new BirthQueue(0u);
            for (int i = 0; i < 5000; i++) queue.Add(Vector3.zero, Vector3.zero, 0.0, 1);
            for (int i = 0; i < 10; i++) queue.Add(Vector3.zero, Vector3.zero, 0.0, 2);
            Assert.That((queue.CollectDue(1.0, 0.01f, Vector3.zero), queue.HasRivals, queue.Waiting), Is.EqualTo((5000, false, 10)));
            for (int i = 0; i < 5000; i++) queue.Add(Vector3.zero, Vector3.zero, 0.0, 1);
            Assert.That((queue.CollectDue(1.0, 0.01f, Vector3.zero), queue.HasRivals, queue.Waiting), Is.EqualTo((4096, true, 914)));
            Assert.That((queue.CollectDue(1.0, 0.01f, Vector3.zero), queue.HasRivals, queue.Waiting), Is.EqualTo((914, false, 0)));
            Assert.That(queue.Taken, Is.EqualTo(10010));
        }

        [Test]
        public void OtherParticlesMayBeMoreOrFewer()
        {
            using (var rig = new StandardRig(Settings(), ParticleSets.Lattice(new Vector3Int(5, 5, 5), Spacing, 0f, 1)))
            {
                rig.Steps(3);
                FluidParticle[] more = ParticleSets.Lattice(new Vector3Int(9, 8, 7), Spacing, 0f, 1);
                rig.Solver.SetParticles(more);
                rig.Steps(3);
                Assert.That(Live(rig).Length, Is.EqualTo(more.Length));
                rig.Solver.SetParticles(new FluidParticle[0]);
                rig.Steps(3);
                Assert.That(Live(rig), Is.Empty);
                Assert.That(rig.Solver.LiveCount, Is.Zero);
            }
        }
    }
}
