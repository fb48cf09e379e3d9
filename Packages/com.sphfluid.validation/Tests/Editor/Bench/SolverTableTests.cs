using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using SphFluid.Laboratory;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>The columns of the table of solvers, from made-up rows and from small liquids.</summary>
    public sealed class SolverTableTests
    {
        private static readonly string[] Parts = { "sort", "motion" };

        [Test]
        public void RowsAreHeldAgainstTheThesisOfTheSameSize()
        {
            BenchColumns table =
                Table((BenchSolver.ThesisCells, 1000, 9.0), (BenchSolver.ThesisOctant, 1000, 12.0), (BenchSolver.Standard, 1000, 3.0),
                (BenchSolver.ThesisFused, 4000, 36.0), (BenchSolver.ThesisCells, 4000, 44.0), (BenchSolver.Standard, 4000, 12.0),
                (BenchSolver.StandardWide, 4000, 20.0));

            Assert.That(table.Column("speedup_thesis_27"), Is.EqualTo(new[] { "1", "0.75", "3", "1.22222", "1", "3.66667", "" }));
            Assert.That(table.Column("speedup_thesis_27_fused"), Is.EqualTo(new[] { "", "", "", "1", "0.818182", "3", "" }));
            Assert.That(table.Column("speedup_thesis_8"), Is.EqualTo(new[] { "1.33333", "1", "4", "", "", "", "" }));
            Assert.That(table.Column("kappa"), Is.EqualTo(new[] { "2", "2", "2", "2", "2", "2", "2.25" }));
        }

        [Test]
        public void StepsTakenAtOnceHaveARowOfTheirMean()
        {
            var table = new BenchColumns(new SolverLayout(Parts), "device", "2026-11-22");
            var row = new BenchRow(BenchConfig.StepsAtOnce(BenchSolver.Standard),
                1000)
            { NeighboursMean = 30.0, CandidatesMean = 195.0, Dispatches = 72, CopySpeed = 1e9 };
            row.Add(new BenchTimes(2, 96.0, new[] { 0.0, 0.0 }).PerStep(row.Config.Steps));
            row.Passes = new BenchTimes(2, 144.0, new[] { 12.0, 72.0 }, 12).PerStep(row.Config.Steps);
            table.Add(row);

            // Two frames of 24 steps in 96 ms, 6 setups in each; in 144 ms with their passes timed.
            Assert.That(table.Column("config").Single(), Is.EqualTo("standard_at_once"));
            Assert.That(table.Column("steps").Single(), Is.EqualTo("24"));
            Assert.That(table.Column("rebuilds").Single(), Is.EqualTo("0.25"));
            Assert.That(table.Column("dispatches").Single(), Is.EqualTo("3"));
            Assert.That(table.Column("gpu_ms_median").Single(), Is.EqualTo("2"));
            Assert.That(table.Column("gpu_ms_stamped").Single(), Is.EqualTo("3"));
            Assert.That(table.Column("share.motion").Single(), Is.EqualTo("0.5"));
        }

        [Test]
        public void SizesThatDoNotFitIntoMemoryAreLeftOutAndNamed()
        {
            BenchPlan all = BenchPlan.Solver(new[] { 16384, 65536, 262144, 1048576 });
            double largest = BenchMemory.Of(all, 262144);
            Assert.That(largest, Is.InRange(3.5 * BenchMemory.Of(all, 65536), 4.5 * BenchMemory.Of(all, 65536)), "bytes go with particles");

            BenchPlan plan = all.Within(largest + CopyBuffers.BytesOfBoth);

            Assert.That(plan.Particles, Is.EqualTo(new[] { 16384, 65536, 262144 }));
            Assert.That(plan.LeftOut, Does.Contain("1,048,576 (").And.Not.Contain("262,144").And.Contain("--particles"));
            Assert.That(BenchPlan.Solver(new[] { 16384 }).Within(largest).LeftOut, Is.Null);
        }

        // Half of a sweep's memory is its largest size: without that all others fit at once.
        [Test]
        public void SizesThatAreKeptAtOnceShareTheMemory()
        {
            double one = BenchMemory.Of(BenchPlan.Sweep(new[] { 65536 }), 65536);
            Assert.That(BenchPlan.Sweep(new[] { 65536, 65536, 65536 }).Within(2.5 * one).Particles, Has.Count.EqualTo(2));
        }

        // As on the device: what a liquid is planned to take is what it takes.
        [Test]
        public void PlannedMemoryIsWhatLiquidsTake()
        {
            GpuTest.Require();
            BenchPlan plan = BenchPlan.Solver(new[] { 4096 });
            long taken = 0;
            foreach (BenchSolver solver in plan.Solvers)
            {
                using (var liquid = new BenchLiquid(TestAssets.Water.Shaders, solver, 4096))
                {
                    GpuTest.Run(cmd => liquid.Solver.RecordSteps(cmd, 1));
                    taken += liquid.Solver.GpuBytes;
                }
            }
            Assert.That(BenchMemory.Of(plan, 4096), Is.EqualTo((double)taken).Within(0.05 * taken));
        }

        [Test]
        public void GrowthIsTheExponentOverASixteenthOfTheSizeAndMore()
        {
            BenchColumns table =
                Table((BenchSolver.Standard, 1000, 100.0), (BenchSolver.Standard, 4000, 8.0), (BenchSolver.Standard, 16000, 32.0),
                (BenchSolver.Standard, 64000, 512.0));

            Assert.That(table.Column("growth_exponent"), Is.EqualTo(new[] { "", "-1.82193", "-0.410964", "1.5" }));
        }

        [Test]
        public void SharesAndRoofline()
        {
            BenchColumns table = Table((BenchSolver.StandardUnordered, 1000, 2.0));
            table.Rows[0].Cells = 500;
            table.Rows[0].CopySpeed = 1e9;

            // 168 · 1,000 + 36 · 500 bytes at 1 GB/s.
            Assert.That(table.Column("bytes_per_particle").Single(), Is.EqualTo("184"));
            Assert.That(table.Column("roofline_ms").Single(), Is.EqualTo("0.184"));
            Assert.That(table.Column("roofline_fraction").Single(), Is.EqualTo("0.092"));
            Assert.That(table.Column("share.sort").Single(), Is.EqualTo("0.25"));
            Assert.That(table.Column("share.motion").Single(), Is.EqualTo("0.5"));
            Assert.That(table.Column("mpairs_per_s").Single(), Is.EqualTo("15"));
            Assert.That(table.Column("candidates_per_neighbour").Single(), Is.EqualTo("6.5"));
        }

        // 1,000 particles are padded to 1,024 pairs: 10 dispatches of the sort move 16 bytes a pair each.
        [Test]
        public void BytesOfAStepGoByItsPasses()
        {
            Assert.That(StepBytes.Standard(1000, 500, true, false, null), Is.EqualTo(192 * 1000 + 36 * 500));
            Assert.That(StepBytes.Standard(1000, 500, true, true, null), Is.EqualTo(252 * 1000 + 36 * 500));
            Assert.That(StepBytes.Standard(1000, 500, false, false, 27.5), Is.EqualTo((168 + 8 + 8 * 27.5) * 1000 + 32 * 500));
            Assert.That(StepBytes.Thesis(1000, 500, 18), Is.EqualTo(388 * 1000 + 8 * 1024 + 10 * 16 * 1024 + 32 * 500));
        }

        [TestCase(1, 2f)]
        [TestCase(509, 2f)]
        [TestCase(1009, 2.25f)]
        public void CandidatesAreThoseOfTheCellsAround(int count, float ratio)
        {
            var domain = new Vector3(0.5f, 0.4f, 0.45f);
            float radius = 0.05f * ratio;
            Vector3[] positions = ParticleSets.Random(count, domain, 1f, 5).Select(p => p.Position).ToArray();
            foreach (bool octant in new[] { false, true })
            {
                var grid = new FluidGrid(domain, octant ? 2f * radius : radius);
                long expected = 0;
                foreach (Vector3 a in positions) expected += positions.Count(b => IsVisited(grid, octant, a, b));
                double mean = CandidateCount.Mean(positions, grid, octant);
                Assert.That(mean, Is.EqualTo(expected / (double)count).Within(1e-9), $"octant {octant}");
                Assert.That(mean, Is.GreaterThanOrEqualTo(1.0 + NeighbourCount.Of(positions, radius).Mean),
                    "all neighbours and itself are among them");
            }
        }

        [TestCase("thesis_27", 18)]
        [TestCase("thesis_27_fused", 9)]
        [TestCase("thesis_8", 18)]
        [TestCase("standard", 5)]
        [TestCase("standard_search", 5)]
        [TestCase("standard_unordered", 4)]
        [TestCase("standard_mesh", 9)]
        [TestCase("standard_2.25", 5)]
        public void DispatchesOfAStep(string name, int expected)
        {
            BenchSolver solver = BenchPlan.Solver(null).Solvers.Single(s => s.Name == name);
            using (var liquid = new BenchLiquid(SurfaceTestScene.LoadShaders(), solver, 500))
            {
                GpuTest.Run(cmd => liquid.Solver.RecordSteps(cmd, 1)); // takes the particles in
                long before = GpuLaboratory.DispatchesRecorded;
                GpuTest.Run(cmd => liquid.Solver.RecordSteps(cmd, 1));

                Assert.That(GpuLaboratory.DispatchesRecorded - before, Is.EqualTo(expected));
                Assert.That(liquid.TriangleCount, solver.HasMesh ? Is.GreaterThan(20) : Is.Zero);
                Assert.That(liquid.Solver.Settings.SupportRadius / liquid.Solver.Settings.Spacing,
                    Is.EqualTo(solver.SupportRatio).Within(1e-5f));
            }
        }

        [TestCase(100)]
        [TestCase(4093)]
        public void TheBlockLeavesTheMeshFree(int count)
        {
            FluidParticle[] block = BenchLiquid.Block(count, true, out float spacing, out float height);

            Assert.That(block.Select(p => p.Position).Distinct().Count(), Is.EqualTo(count));
            Assert.That(block.Any(p => BenchMesh.Overlaps(p.Position, spacing)), Is.False);
            Assert.That(height, Is.LessThan(BenchLiquid.Edge));
        }

        [Test]
        public void TheLiquidAroundTheMeshSettlesFirst()
        {
            IReadOnlyList<BenchSolver> solvers = BenchPlan.Solver(new[] { 64 }).Solvers;

            Assert.That(solvers.First(), Is.SameAs(BenchSolver.StandardMesh));
            Assert.That(solvers.Select(s => s.Name).Distinct().Count(), Is.EqualTo(10));
        }

        // The 27 cells about a's, or the 8 that its octant touches.
        private static bool IsVisited(in FluidGrid grid, bool octant, Vector3 a, Vector3 b)
        {
            for (int axis = 0; axis < 3; axis++)
            {
                float place = (a[axis] - grid.Origin[axis]) / grid.CellSize[axis];
                int own = Mathf.FloorToInt(place), other = Mathf.FloorToInt((b[axis] - grid.Origin[axis]) / grid.CellSize[axis]);
                int low = octant ? (place - own < 0.5f ? own - 1 : own) : own - 1;
                int high = octant ? low + 1 : own + 1;
                if (other < low || other > high) return false;
            }
            return true;
        }

        // Two frames a sample; with the passes timed a quarter of each in the first part, half in the second.
        private static BenchColumns Table(params (BenchSolver Solver, int Particles, double Milliseconds)[] rows)
        {
            var table = new BenchColumns(new SolverLayout(Parts), "device", "2026-11-22");
            foreach ((BenchSolver solver, int particles, double milliseconds) in rows)
            {
                var row = new BenchRow(BenchConfig.Step(solver), particles)
                {
                    NeighboursMean = 30.0, CandidatesMean = 195.0,
                    Dispatches = 18, CopySpeed = 1e9
                };
                row.Add(new BenchTimes(2, 2.0 * milliseconds, new[] { 0.0, 0.0 }));
                row.Passes = new BenchTimes(2, 2.0 * milliseconds, new[] { 0.5 * milliseconds, milliseconds });
                table.Add(row);
            }
            return table;
        }
    }
}
