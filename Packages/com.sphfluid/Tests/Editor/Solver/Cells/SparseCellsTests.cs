using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>
    /// A liquid whose cells are stored only where there are particles goes as one whose cells are all stored, to the last bit, and a domain
    /// of any size has room.
    /// </summary>
    public sealed class SparseCellsTests
    {
        private const float Spacing = 0.05f;
        private static readonly Vector3 Domain = new Vector3(1f, 1.2f, 0.8f);

        // Words of a table of all cells are none.
        [TestCase(1048576, 0)]
        [TestCase(1048577, 1025)]
        [TestCase(1049600, 1025)]
        [TestCase(1049601, 1026)]
        [TestCase(int.MaxValue - 1, 2097152)]
        public void TheNumberOfCellsDecides(int cells, int words) => Assert.That(SparseCells.For(cells).Words, Is.EqualTo(words));

        [TestCase(FluidMethodKind.Standard)]
        [TestCase(FluidMethodKind.Robust)]
        public void CellsOfALevelTakeTenMegabytes(FluidMethodKind method)
        {
            const int count = 200000;
            FluidSolverSettings settings = Settings(method, new Vector3(100f, 20f, 100f));
            double cells = CellChecks.Needed(settings);
            Assert.That(cells, Is.GreaterThan(1e8).And.LessThan(CellChecks.Most(method)));
            SparseCells sparse = SparseCells.For((int)cells);
            using (var buffers = new CellBuffers(count, (int)cells, sparse, true))
            using (var without = new CellBuffers(count, 0, default, true))
            using (var published = new PublishedBuffers(count, (int)cells, sparse, true))
            using (var publishedWithout = new PublishedBuffers(count, 0, default, true))
            {
                long table = buffers.CellTable.Bytes, ranges = published.GridIndices.Bytes;
                Assert.That(table + ranges, Is.LessThanOrEqualTo(10_000_000L));
                Assert.That(buffers.Bytes - table, Is.EqualTo(without.Bytes - without.CellTable.Bytes), "nothing else goes with the cells");
                Assert.That(published.Bytes - ranges, Is.EqualTo(publishedWithout.Bytes - publishedWithout.GridIndices.Bytes));
            }
            long planned = FluidMethods.Get(method).PlannedBytes(settings, count, false);
            settings.DomainSize = new Vector3(2f, 2f, 2f);
            Assert.That(planned - FluidMethods.Get(method).PlannedBytes(settings, count, false), Is.LessThan(10_000_000L));
        }

        [TestCase(FluidMethodKind.Standard)]
        [TestCase(FluidMethodKind.Robust)]
        public void ALevelStartsStepsAndKeepsItsParticles(FluidMethodKind method)
        {
            FluidSolverSettings settings = Settings(method, new Vector3(100f, 20f, 100f));
            FluidParticle[] block = ParticleSets.Lattice(new Vector3Int(6, 6, 6), Spacing, 0.02f * Spacing, 3);
            Vector3 corner = 0.5f * settings.DomainSize - 0.2f * Vector3.one;
            FluidParticle[] start = block.Select(p => new FluidParticle(p.Position - corner, Vector3.zero, p.Id))
                .Concat(block.Select(p => new FluidParticle(p.Position + corner, Vector3.zero, p.Id + 216u)))
                .Concat(block.Select(p => new FluidParticle(p.Position, Vector3.zero, p.Id + 432u))).ToArray();
            using (var rig = new StandardRig(settings, start))
            {
                Assert.That(rig.Solver.State.Sparse.AreUsed);
                rig.Steps(20);
                FluidParticle[] after = rig.Particles();
                Assert.That(after.Select(p => p.Id).OrderBy(id => id), Is.EqualTo(start.Select(p => p.Id)));
                Assert.That(after.All(p => !p.IsRemoved && (p.Position - start[(int)p.Id].Position).magnitude < 0.2f));
                // Within each block some are dense: neighbours were found. Far from the middle a place is rounded to 4e-6 m.
                float[] densities = rig.Densities();
                for (int third = 0; third < 3; third++)
                {
                    Assert.That(Enumerable.Range(0, after.Length).Where(i => after[i].Id / 216u == third).Max(i => densities[i]),
                        Is.GreaterThan(0.95f * settings.RestDensity));
                }
                Assert.That(rig.Solver.ReadCountersNow().NonFinite, Is.Zero);
            }
        }

        [TestCase(FluidMethodKind.Standard, FluidAxes.None, true)]
        [TestCase(FluidMethodKind.Standard, FluidAxes.X | FluidAxes.Z, true)]
        [TestCase(FluidMethodKind.Standard, FluidAxes.X, false)]
        [TestCase(FluidMethodKind.Robust, FluidAxes.None, true)]
        [TestCase(FluidMethodKind.Robust, FluidAxes.Z, true)]
        public void AFallingBlockIsEqualToTheLastBit(FluidMethodKind method, FluidAxes periodic, bool lists)
        {
            FluidSolverSettings settings = Settings(method, Domain);
            settings.Boundaries.Periodic = periodic;
            if (method == FluidMethodKind.Standard) settings = settings.WithOwn((ref StandardSettings own) => own.NeighbourList = lists);
            AssertEqual(() =>
            {
                using (var rig = new StandardRig(settings, Block(0f)))
                {
                    for (int turn = 0; turn < 4; turn++) rig.Steps(15);
                    return Result(rig.Solver);
                }
            });
        }

        [TestCase(FluidMethodKind.Standard)]
        [TestCase(FluidMethodKind.Robust)]
        public void ABlockAmongMeshesIsEqualToTheLastBit(FluidMethodKind method)
        {
            FluidSolverSettings settings = Settings(method, Domain);
            AssertEqual(() =>
            {
                using (var rig = new BodyRig(settings))
                {
                    rig.AddBall(0.15f, 8).localPosition = new Vector3(0f, -0.4f, 0f);
                    Transform box = rig.AddBox(new Vector3(0.1f, 1f, 0.6f));
                    rig.Start(Block(0.1f));
                    for (int frame = 0; frame < 6; frame++)
                    {
                        box.localPosition = new Vector3(0.4f - 0.01f * frame, -0.2f, 0f);
                        rig.Frame(8);
                    }
                    return Result(rig.Solver);
                }
            });
        }

        // Into buffers that grow, through an open floor, from a drain, and the oldest leave.
        [TestCase(FluidMethodKind.Standard)]
        [TestCase(FluidMethodKind.Robust)]
        public void BirthsAndDrainsAreEqualToTheLastBit(FluidMethodKind method)
        {
            FluidSolverSettings settings = Settings(method, Domain);
            settings.Boundaries.Open = FluidFaces.LowX;
            Vector3[] sites = ParticleSets.Lattice(new Vector3Int(7, 3, 7), 1.2f * Spacing, 0f, 1).Select(p => p.Position).ToArray();
            AssertEqual(() =>
            {
                using (var rig = new StandardRig(settings, Block(0f).Take(50).ToArray()))
                {
                    rig.Solver.Exchange.MostParticles = 500;
                    rig.Solver.Exchange.Recycles = true;
                    var drain = DrainZone.Box(Matrix4x4.TRS(new Vector3(0.3f, -0.5f, 0f), Quaternion.identity,
                        0.2f * Vector3.one));
                    rig.Solver.Exchange.SetDrains(new[] { (drain, 0) });
                    for (int turn = 0; turn < 8; turn++)
                    {
                        BirthQueue births = rig.Solver.Exchange.Births;
                        foreach (Vector3 site in sites)
                        {
                            births.Add(site, new Vector3(-1f, -2f, 0.3f), rig.Solver.SimulatedTime, SourceCounts.Added);
                        }
                        rig.Steps(7);
                    }
                    FluidCounters counters = rig.Solver.ReadCountersNow();
                    Assert.That(counters.Born, Is.GreaterThan(400));
                    Assert.That(counters.Blocked, Is.GreaterThan(10));
                    Assert.That(counters.Removed, Is.GreaterThan(20));
                    Assert.That(rig.Particles().Count(p => !p.IsRemoved), Is.EqualTo(rig.Solver.LiveCount));
                    return Result(rig.Solver);
                }
            });
        }

        // Readers of published particles: statistics, and the cells as a kernel of a user's finds them (FluidBuffersTests runs in both).
        [TestCase(FluidAxes.None)]
        [TestCase(FluidAxes.X | FluidAxes.Y)]
        public void StatisticsAreTheSame(FluidAxes periodic)
        {
            FluidSolverSettings settings = Settings(FluidMethodKind.Standard, Domain);
            settings.Boundaries.Periodic = periodic;
            settings.Boundaries.Open = periodic == FluidAxes.None ? FluidFaces.LowX : FluidFaces.None;
            AssertEqual(() =>
            {
                using (var rig = new StandardRig(settings, Block(-1f)))
                using (var meter = new FluidStatisticsMeter(rig.Shaders, rig.Solver))
                {
                    rig.Steps(60);
                    FluidStatistics found = meter.MeasureNow();
                    Assert.That((found.Misplaced, found.Listed), Is.EqualTo((0, (long)found.ParticleCount)));
                    Assert.That(found.MaxCellCount, Is.GreaterThan(5));
                    return new[] { (ulong)found.MaxCellCount, (ulong)found.ParticleCount, (ulong)found.MaxNeighbours };
                }
            });
        }

        private static FluidSolverSettings Settings(FluidMethodKind method, Vector3 domain) =>
            BodyRig.Water(domain, Spacing, 0.4f, 2f, method);

        private static FluidParticle[] Block(float speed) => ParticleSets.Lattice(new Vector3Int(9, 8, 9), Spacing, 0.02f * Spacing, 3)
            .Select(p => new FluidParticle(p.Position - 0.1f * Vector3.up, speed * Vector3.right, p.Id)).ToArray();

        private static ulong[] Result(FluidSolver solver)
        {
            ulong hash = StateHash.Compute(solver);
            float[] densities = GpuTest.Read<float>(solver.Density, solver.ParticleCount);
            return new[] { hash, StateHash.Compute(new ReadOnlySpan<float>(densities)) };
        }

        private static void AssertEqual(Func<ulong[]> run)
        {
            ulong[] dense, sparse;
            using (new ForcedCells(false)) dense = run();
            using (new ForcedCells(true)) sparse = run();
            Assert.That(sparse, Is.EqualTo(dense));
        }
    }
}
