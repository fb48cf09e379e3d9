using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>A table to measure: its rows are all configurations at all numbers of particles.</summary>
    sealed class BenchPlan
    {
        static readonly int[] ThesisParticles = { 16384, 32768, 65536 };
        static readonly int[] SolverParticles = { 16384, 65536, 262144, 1048576, 4194304 };

        // A CPU device takes 1,048,576 on request.
        const int MostOnCpu = 262144;

        BenchPlan(string name, IReadOnlyList<BenchConfig> configs, IReadOnlyList<int> particles, IReadOnlyList<BenchBlock> blocks, IBenchLayout layout)
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

        public IReadOnlyList<int> Particles { get; }

        /// <summary>What is timed within a frame.</summary>
        public IReadOnlyList<BenchBlock> Blocks { get; }

        public IBenchLayout Layout { get; }

        /// <summary>True: all rounds of a number of particles before the next number, so that one size is in memory at a time.</summary>
        public bool SizeBySize { get; private set; }

        /// <summary>Whether the device's copy speed is measured too.</summary>
        public bool NeedsCopySpeed { get; private set; }

        /// <summary>The solvers of the configurations; first the one whose liquid settles, so that none of its particles is in a mesh.</summary>
        public IReadOnlyList<BenchSolver> Solvers => Configs.Select(c => c.Solver).Distinct().OrderByDescending(s => s.HasMesh).ToList();

        /// <summary>Tables 3 and 4 of the thesis.</summary>
        /// <param name="particles">Numbers of particles; null for the thesis's.</param>
        /// <param name="grids">Marching-cubes grids.</param>
        public static BenchPlan Thesis(IReadOnlyList<int> particles, IEnumerable<int> grids)
        {
            var configs = new List<BenchConfig> { BenchConfig.SphOnly, BenchConfig.SphParticles };
            configs.AddRange(grids.Select(BenchConfig.SphMarchingCubes));
            return Thesis("thesis", configs, particles ?? ThesisParticles);
        }

        /// <summary>The thesis's step alone over many sizes.</summary>
        public static BenchPlan Sweep(IReadOnlyList<int> particles) => Thesis("sweep", new[] { BenchConfig.SphOnly }, particles);

        /// <summary>The thesis's pipeline against the Standard method.</summary>
        /// <param name="particles">Numbers of particles; null for those that suit the device.</param>
        public static BenchPlan Solver(IReadOnlyList<int> particles)
        {
            BenchConfig[] configs = new[]
            {
                BenchSolver.ThesisCells, BenchSolver.ThesisOctant, BenchSolver.Standard, BenchSolver.StandardSearch,
                BenchSolver.StandardUnordered, BenchSolver.StandardMesh, BenchSolver.StandardWide,
            }.Select(BenchConfig.Step).ToArray();
            IReadOnlyList<int> sizes = particles ?? SolverParticles.Where(n => n <= MostOnCpu || !SurfaceGridSizes.IsSoftwareDevice).ToArray();
            return new BenchPlan("solver", configs, sizes, BenchBlocks.Step, new SolverLayout(BenchBlocks.Step.Select(b => b.Name)))
            {
                SizeBySize = true,
                NeedsCopySpeed = true,
            };
        }

        static BenchPlan Thesis(string name, IReadOnlyList<BenchConfig> configs, IReadOnlyList<int> particles) =>
            new BenchPlan(name, configs, particles, BenchBlocks.Thesis, new ThesisLayout(BenchBlocks.Thesis.Select(b => b.Name)));
    }
}
