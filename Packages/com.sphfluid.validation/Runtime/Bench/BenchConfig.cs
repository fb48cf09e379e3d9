namespace SphFluid.Validation
{
    /// <summary>What a row's frame does: a step or none, and what is drawn.</summary>
    public readonly struct BenchConfig
    {
        // A frame of 30 a second has more of them; a sort serves fewer.
        private const int ManySteps = 24;

        private BenchConfig(BenchSolver solver, string name, BenchSurfaceKind kind, int grid = 0, int steps = 1,
            FluidSurfaceQuality? quality = null,
            BenchWaterLook? water = null)
        {
            Solver = solver;
            Name = name;
            Kind = kind;
            Grid = grid;
            Steps = steps;
            Quality = quality;
            Water = water;
        }

        /// <summary>The thesis's step alone.</summary>
        public static BenchConfig SphOnly => new BenchConfig(BenchSolver.ThesisOctant, "sph_only", BenchSurfaceKind.None);

        /// <summary>The thesis's step, and the particles drawn as textured squares.</summary>
        public static BenchConfig SphParticles => new BenchConfig(BenchSolver.ThesisOctant, "sph_particles", BenchSurfaceKind.Particles);

        /// <summary>What computes the step and holds the particles.</summary>
        public BenchSolver Solver { get; }

        /// <summary>Name in tables: sph_only, sph_particles or sph_mc; of a step alone its solver's, of a surface alone its own.</summary>
        public string Name { get; }

        /// <summary>What is drawn.</summary>
        public BenchSurfaceKind Kind { get; }

        /// <summary>Cells a side of the marching-cubes grid; 0 without one, and where the field's quality gives the cell.</summary>
        public int Grid { get; }

        /// <summary>Steps that a frame takes at once; 0: the liquid stands still.</summary>
        public int Steps { get; }

        /// <summary>Whether a frame takes steps.</summary>
        public bool HasStep => Steps > 0;

        /// <summary>Quality of the sparse surface's own field; null for the thesis's field.</summary>
        public FluidSurfaceQuality? Quality { get; }

        /// <summary>How it is drawn as clear water; null for an opaque body.</summary>
        public BenchWaterLook? Water { get; }

        /// <summary>Whether a surface is drawn.</summary>
        public bool HasSurface => Kind > BenchSurfaceKind.Particles;

        /// <summary>The drawing in the words of --surface, and of one that only the benchmark has.</summary>
        public string Surface
        {
            get
            {
                switch (Kind)
                {
                    case BenchSurfaceKind.None: return "none";
                    case BenchSurfaceKind.Particles: return "particles";
                    case BenchSurfaceKind.Geometry: return "marching-cubes-gs";
                    case BenchSurfaceKind.DenseCompute: return "marching-cubes-dense";
                    case BenchSurfaceKind.Whitewater: return "marching-cubes+whitewater";
                    default: return "marching-cubes";
                }
            }
        }

        /// <summary>The surface's field: thesis, or the quality's name; empty without a surface.</summary>
        public string Field => !HasSurface ? "" : Quality.HasValue ? Quality.Value.ToString().ToLowerInvariant() : "thesis";

        /// <summary>Name for people, e.g. SPH + MC 64.</summary>
        public string Title
        {
            get
            {
                if (Water.HasValue) return $"Water, {Water.Value.Title}";
                if (Kind == BenchSurfaceKind.Whitewater) return "Sparse, whitewater";
                if (!HasStep) return Quality.HasValue ? $"Sparse, {Field}" : $"{Drawing} {Grid}";
                if (HasSurface) return $"SPH + MC {Grid}";
                if (Steps > 1) return Solver.Title + ", at once";
                return Name == Solver.Name ? Solver.Title : Kind == BenchSurfaceKind.None ? "SPH only" : "SPH + particles";
            }
        }

        private string Drawing => Kind == BenchSurfaceKind.Geometry ? "Geometry shader" : Kind == BenchSurfaceKind.DenseCompute
            ? "Dense compute" : "Sparse";

        /// <summary>The thesis's step, and the surface by marching cubes in a geometry shader.</summary>
        /// <param name="cells">Cells a side of its grid.</param>
        public static BenchConfig SphMarchingCubes(int cells) =>
            new BenchConfig(BenchSolver.ThesisOctant, "sph_mc", BenchSurfaceKind.Geometry, cells);

        /// <summary>
        /// Many steps recorded together, as a game's frame does, so that a method may let one neighbour setup serve several.
        /// </summary>
        /// <param name="solver">What computes them.</param>
        public static BenchConfig StepsAtOnce(BenchSolver solver) =>
            new BenchConfig(solver, solver.Name + "_at_once", BenchSurfaceKind.None, steps: ManySteps);

        /// <summary>A step alone, with a neighbour setup of its own.</summary>
        /// <param name="solver">What computes it.</param>
        public static BenchConfig Step(BenchSolver solver) => new BenchConfig(solver, solver.Name, BenchSurfaceKind.None);

        /// <summary>The thesis's surface without a step.</summary>
        /// <param name="cells">Cells a side of its grid.</param>
        public static BenchConfig GeometrySurface(int cells) => Still("gs", BenchSurfaceKind.Geometry, cells);

        /// <summary>The dense compute surface without a step.</summary>
        /// <param name="cells">Cells a side of its grid.</param>
        public static BenchConfig DenseSurface(int cells) => Still("dense", BenchSurfaceKind.DenseCompute, cells);

        /// <summary>The sparse surface with the thesis's field, without a step.</summary>
        /// <param name="cells">Cells a side of the grid that its blocks are cut from.</param>
        public static BenchConfig SparseSurface(int cells) => Still("sparse", BenchSurfaceKind.Sparse, cells);

        /// <summary>The sparse surface with a field and a cell of its own, without a step.</summary>
        /// <param name="quality">The field's quality.</param>
        public static BenchConfig SparseSurface(FluidSurfaceQuality quality) =>
            Still("sparse_" + quality.ToString().ToLowerInvariant(), BenchSurfaceKind.Sparse, 0, quality);

        /// <summary>The sparse surface of the default quality as clear water, without a step.</summary>
        /// <param name="look">How it is drawn.</param>
        public static BenchConfig WaterSurface(BenchWaterLook look) =>
            Still("water_" + look.Name, BenchSurfaceKind.Water, 0, FluidSurfaceQuality.Default, look);

        /// <summary>The sparse surface of the default quality with as many particles of whitewater as the liquid has.</summary>
        public static BenchConfig Whitewater => Still("sparse_whitewater", BenchSurfaceKind.Whitewater, 0, FluidSurfaceQuality.Default);

        private static BenchConfig Still(string name, BenchSurfaceKind kind, int cells, FluidSurfaceQuality? quality = null,
            BenchWaterLook? water = null) =>
                new BenchConfig(BenchSolver.ThesisOctant, name, kind, cells, 0, quality, water);
    }
}
