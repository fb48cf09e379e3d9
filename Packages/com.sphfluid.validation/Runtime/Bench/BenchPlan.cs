using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;
using static System.FormattableString;

namespace SphFluid.Validation
{
    /// <summary>A table to measure: its rows are the configurations at all numbers of particles.</summary>
    internal sealed class BenchPlan
    {
        private static readonly int[] ThesisParticles = { 16384, 32768, 65536 };
        private static readonly int[] ThesisGrids = { 32, 64, 128, 256 };
        private static readonly int[] SolverParticles = { 16384, 65536, 262144, 1048576, 4194304 };
        private static readonly int[] SurfaceParticles = { 16384, 65536, 262144, 1048576 };
        private static readonly int[] SurfaceGrids = { 32, 64, 128, 256, 512 };

        // Each step of the look against the one before it, and the spray of the default look.
        private static readonly BenchWaterLook[] WaterLooks =
        {
            new BenchWaterLook(FluidWaterQuality.Fast, 0), new BenchWaterLook(FluidWaterQuality.Balanced, 0),
            new BenchWaterLook(FluidWaterQuality.Fine, 0),
            new BenchWaterLook(FluidWaterQuality.Fine, new FluidWaterLook().Spray),
        };

        // A CPU device takes 1,048,576 on request.
        private const int MostOnCpu = 262144;

        // Cells a side of a dense grid at most, the thesis's finest: 512 are 540 MB.
        private const int MostDenseCells = 256;

        // On a CPU device the geometry shader takes five seconds for 256 cells a side, whatever the liquid: with more particles on request.
        private const int MostCpuGeometryCells = 128;
        private const int MostCpuGeometryParticles = 65536;

        private Func<BenchConfig, int, bool> isLeftOut = (config, particles) => false;

        private BenchPlan(string name, IReadOnlyList<BenchConfig> configs, IReadOnlyList<int> particles, IReadOnlyList<BenchBlock> blocks,
            BenchLayout layout)
        {
            Name = name;
            Configs = configs;
            Particles = particles;
            Blocks = blocks;
            Layout = layout;
        }

        /// <summary>Name of the table, also the file's.</summary>
        public string Name { get; }

        public IReadOnlyList<BenchConfig> Configs { get; }

        /// <summary>Rows that are not measured, as a sentence; null when all are.</summary>
        public string LeftOut { get; private set; }

        public IReadOnlyList<int> Particles { get; private set; }

        /// <summary>What is timed within a frame.</summary>
        public IReadOnlyList<BenchBlock> Blocks { get; }

        public BenchLayout Layout { get; }

        /// <summary>True: all rounds of a number of particles before the next number, so that one size is in memory at a time.</summary>
        public bool SizeBySize { get; private set; }

        /// <summary>Whether the device's copy speed is measured too.</summary>
        public bool NeedsCopySpeed { get; private set; }

        /// <summary>
        /// The solvers of the configurations; first the one whose liquid settles, so that none of its particles is in a mesh.
        /// </summary>
        public IReadOnlyList<BenchSolver> Solvers => Configs.Select(c => c.Solver).Distinct().OrderByDescending(s => s.HasMesh).ToList();

        /// <summary>Tables 3 and 4 of the thesis.</summary>
        /// <param name="particles">Numbers of particles; null for the thesis's.</param>
        /// <param name="grids">Marching-cubes grids; null for the thesis's.</param>
        /// <param name="missing">What the device misses for the geometry shader, as a sentence; null when nothing.</param>
        public static BenchPlan Thesis(IReadOnlyList<int> particles, IReadOnlyList<int> grids, string missing)
        {
            grids ??= ThesisGrids;
            var configs = new List<BenchConfig> { BenchConfig.SphOnly, BenchConfig.SphParticles };
            if (missing == null) configs.AddRange(grids.Select(BenchConfig.SphMarchingCubes));
            BenchPlan plan = Thesis("thesis", configs, particles ?? ThesisParticles);
            if (missing != null && grids.Count > 0) plan.LeftOut = missing + " The rows with marching cubes are left out.";
            return plan;
        }

        /// <summary>The thesis's step alone over many sizes.</summary>
        public static BenchPlan Sweep(IReadOnlyList<int> particles) => Thesis("sweep", new[] { BenchConfig.SphOnly }, particles);

        /// <summary>The thesis's pipeline against the Standard method.</summary>
        /// <param name="particles">Numbers of particles; null for those that suit the device.</param>
        public static BenchPlan Solver(IReadOnlyList<int> particles)
        {
            BenchConfig[] configs =
            {
                BenchConfig.Step(BenchSolver.ThesisCells), BenchConfig.Step(BenchSolver.ThesisFused),
                BenchConfig.Step(BenchSolver.ThesisOctant),
                BenchConfig.Step(BenchSolver.Standard), BenchConfig.StepsAtOnce(BenchSolver.Standard),
                BenchConfig.Step(BenchSolver.StandardSearch), BenchConfig.Step(BenchSolver.StandardUnordered),
                BenchConfig.Step(BenchSolver.StandardMesh), BenchConfig.StepsAtOnce(BenchSolver.StandardMesh),
                BenchConfig.Step(BenchSolver.StandardWide), BenchConfig.StepsAtOnce(BenchSolver.StandardWide),
                BenchConfig.Step(BenchSolver.Robust), BenchConfig.StepsAtOnce(BenchSolver.Robust),
                BenchConfig.StepsAtOnce(BenchSolver.RobustWide),
            };
            return new BenchPlan("solver", configs, particles ?? ForDevice(SolverParticles), FrameBlocks.Step,
                new SolverLayout(FrameBlocks.Step.Select(b => b.Name)))
            {
                SizeBySize = true,
                NeedsCopySpeed = true,
            };
        }

        /// <summary>
        /// Surfaces without steps: the thesis's and a dense compute one up to 256 cells a side, sparse ones at the same and their own
        /// cells.
        /// </summary>
        /// <param name="particles">Numbers of particles; null for those that suit the device.</param>
        /// <param name="grids">Cells a side with the thesis's field; null for the table's own.</param>
        /// <param name="missing">What the device misses for the geometry shader, as a sentence; null when nothing.</param>
        public static BenchPlan Surface(IReadOnlyList<int> particles, IReadOnlyList<int> grids, string missing)
        {
            var configs = new List<BenchConfig>();
            foreach (int cells in grids ?? SurfaceGrids)
            {
                bool dense = cells <= MostDenseCells;
                if (dense && missing == null) configs.Add(BenchConfig.GeometrySurface(cells));
                if (dense) configs.Add(BenchConfig.DenseSurface(cells));
                configs.Add(BenchConfig.SparseSurface(cells));
            }
            configs
                .AddRange(new[] { FluidSurfaceQuality.Cheap, FluidSurfaceQuality.Default,
                    FluidSurfaceQuality.High }.Select(BenchConfig.SparseSurface));
            configs.AddRange(WaterLooks.Select(BenchConfig.WaterSurface));
            configs.Add(BenchConfig.Whitewater);
            var plan = new BenchPlan("surface", configs, particles ?? ForDevice(SurfaceParticles), FrameBlocks.Surface,
                new SurfaceLayout(FrameBlocks.Surface.Select(b => b.Name)))
            { SizeBySize = true };
            if (missing != null)
                plan.LeftOut = missing + " The rows of the geometry shader are left out.";
            else if (particles == null && FluidSupport.IsSoftwareDevice && configs.Exists(IsSlowOnCpu))
                plan.LeaveOutSlowRows();
            return plan;
        }

        /// <summary>The configurations at a number of particles.</summary>
        public IReadOnlyList<BenchConfig> ConfigsOf(int count) => Configs.Where(c => !isLeftOut(c, count)).ToList();

        /// <summary>Leaves out the numbers of particles that do not fit into some bytes of GPU memory, and names them.</summary>
        public BenchPlan Within(double bytes)
        {
            double taken = NeedsCopySpeed ? CopyBuffers.BytesOfBoth : 0.0;
            var fitting = new List<int>();
            var missing = new List<string>();
            foreach (int particles in Particles)
            {
                double needed = taken + BenchMemory.Of(this, particles);
                if (needed > bytes)
                {
                    missing.Add(
                        double.IsInfinity(needed) ? Invariant($"{particles:N0} (a buffer that is larger than the device allows)")
                            : Invariant($"{particles:N0} ({needed / 1e9:F1} GB)"));
                    continue;
                }
                fitting.Add(particles);
                if (!SizeBySize) taken = needed;
            }
            if (missing.Count == 0) return this;
            string left = $"{Name}: left out for want of memory: {string.Join(", ", missing)}; " +
                Invariant($"{SystemInfo.graphicsDeviceName} has {bytes / 1e9:F1} GB for a table. With --particles they are measured.");
            LeftOut = LeftOut == null ? left : $"{LeftOut} {left}";
            Particles = fitting;
            return this;
        }

        private static bool IsSlowOnCpu(BenchConfig config) => config.Kind == BenchSurfaceKind.Geometry &&
            config.Grid > MostCpuGeometryCells;

        private void LeaveOutSlowRows()
        {
            isLeftOut = (config, count) => IsSlowOnCpu(config) && count > MostCpuGeometryParticles;
            LeftOut =
                $"The geometry shader's rows with more than {MostCpuGeometryCells} cells a side are left out above " +
                $"{MostCpuGeometryParticles} particles: a CPU draws. " +
                "With --particles they are measured.";
        }

        private static int[] ForDevice(int[] sizes) => sizes.Where(n => n <= MostOnCpu || !FluidSupport.IsSoftwareDevice).ToArray();

        private static BenchPlan Thesis(string name, IReadOnlyList<BenchConfig> configs, IReadOnlyList<int> particles) =>
            new BenchPlan(name, configs, particles, FrameBlocks.Thesis, new ThesisLayout(name, FrameBlocks.Thesis.Select(b => b.Name)));
    }
}
