namespace SphFluid.Validation
{
    /// <summary>What a row's frame does: one step, and what is drawn. Names of drawings as in the thesis's tables.</summary>
    public readonly struct BenchConfig
    {
        BenchConfig(BenchSolver solver, string name, string surface, int grid)
        {
            Solver = solver;
            Name = name;
            Surface = surface;
            Grid = grid;
        }

        /// <summary>The thesis's step alone.</summary>
        public static BenchConfig SphOnly => new BenchConfig(BenchSolver.ThesisOctant, "sph_only", "none", 0);

        /// <summary>The thesis's step, and the particles drawn as textured squares.</summary>
        public static BenchConfig SphParticles => new BenchConfig(BenchSolver.ThesisOctant, "sph_particles", "particles", 0);

        /// <summary>What computes the step.</summary>
        public BenchSolver Solver { get; }

        /// <summary>sph_only, sph_particles or sph_mc; of a step alone its solver's name.</summary>
        public string Name { get; }

        /// <summary>The drawing in the words of --surface.</summary>
        public string Surface { get; }

        /// <summary>Cells a side of the marching-cubes grid; 0 without one.</summary>
        public int Grid { get; }

        /// <summary>Name for people, e.g. SPH + MC 64.</summary>
        public string Title
        {
            get
            {
                if (Grid > 0)
                    return $"SPH + MC {Grid}";
                return Name == Solver.Name ? Solver.Title : Surface == "none" ? "SPH only" : "SPH + particles";
            }
        }

        /// <summary>The thesis's step, and the surface by marching cubes in a geometry shader.</summary>
        /// <param name="cells">Cells a side of its grid.</param>
        public static BenchConfig SphMarchingCubes(int cells) => new BenchConfig(BenchSolver.ThesisOctant, "sph_mc", "marching-cubes-gs", cells);

        /// <summary>A step alone.</summary>
        /// <param name="solver">What computes it.</param>
        public static BenchConfig Step(BenchSolver solver) => new BenchConfig(solver, solver.Name, "none", 0);
    }
}
