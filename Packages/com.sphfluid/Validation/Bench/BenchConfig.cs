namespace SphFluid.Validation
{
    /// <summary>What a row of the thesis's tables does in a frame beside its one step; names as in the published table.</summary>
    public readonly struct BenchConfig
    {
        BenchConfig(string name, string surface, int grid)
        {
            Name = name;
            Surface = surface;
            Grid = grid;
        }

        /// <summary>The step alone.</summary>
        public static BenchConfig SphOnly => new BenchConfig("sph_only", "none", 0);

        /// <summary>The step, and the particles drawn as textured squares.</summary>
        public static BenchConfig SphParticles => new BenchConfig("sph_particles", "particles", 0);

        /// <summary>sph_only, sph_particles or sph_mc.</summary>
        public string Name { get; }

        /// <summary>The drawing in the words of --surface.</summary>
        public string Surface { get; }

        /// <summary>Cells a side of the marching-cubes grid; 0 without one.</summary>
        public int Grid { get; }

        /// <summary>Name for people, e.g. SPH + MC 64.</summary>
        public string Title => Grid > 0 ? $"SPH + MC {Grid}" : Name == "sph_only" ? "SPH only" : "SPH + particles";

        /// <summary>The step, and the surface by marching cubes in a geometry shader.</summary>
        /// <param name="cells">Cells a side of its grid.</param>
        public static BenchConfig SphMarchingCubes(int cells) => new BenchConfig("sph_mc", "marching-cubes-gs", cells);
    }
}
