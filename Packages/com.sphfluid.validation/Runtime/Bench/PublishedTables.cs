namespace SphFluid.Validation
{
    /// <summary>
    /// Tables 3 and 4 of G. Figueroa, <i>A Fast Fluid Simulator Using Smoothed-Particle Hydrodynamics</i>, MSc thesis, Arizona State
    /// University, December 2012: frames a second on System 1 (GeForce GTX 580, Core i7-2700 3.50 GHz) and System 2 (GeForce
    /// GTX 430, Core i7 950 3.07 GHz), Windows 7, Direct3D 11. The thesis states neither the scene nor the picture's size nor the
    /// steps a frame: ratios and orders can be compared, single figures cannot.
    /// </summary>
    public static class PublishedTables
    {
        private static readonly int[] particles = { 16384, 32768, 65536 };
        private static readonly int[] grids = { 32, 64, 128, 256 };

        // A row a configuration: SPH only, SPH + particles, SPH + MC 32, 64, 128, 256. A column a number of particles.
        private static readonly int[,] system1 = { { 920, 915, 910 }, { 903, 895, 860 }, { 608, 524, 440 }, { 314, 241, 184 },
            { 86, 65, 49 }, { 12, 8, 7 } };
        private static readonly int[,] system2 = { { 835, 805, 798 }, { 800, 790, 755 }, { 537, 463, 389 }, { 277, 212, 180 },
            { 78, 60, 44 }, { 10, 7, 4 } };

        /// <summary>Table 3: frames a second on System 1 (GTX 580), or null where the table has no such row.</summary>
        /// <param name="config">Configuration.</param>
        /// <param name="count">Number of particles.</param>
        public static int? System1(in BenchConfig config, int count) => Find(system1, config, count);

        /// <summary>Table 4: frames a second on System 2 (GTX 430), or null where the table has no such row.</summary>
        /// <param name="config">Configuration.</param>
        /// <param name="count">Number of particles.</param>
        public static int? System2(in BenchConfig config, int count) => Find(system2, config, count);

        private static int? Find(int[,] table, in BenchConfig config, int count)
        {
            int column = System.Array.IndexOf(particles, count);
            int row = config.Grid > 0 ? System.Array.IndexOf(grids, config.Grid) + 2 : config.Name == "sph_only" ? 0 : 1;
            bool found = column >= 0 && (config.Grid == 0 || row >= 2);
            return found ? table[row, column] : (int?)null;
        }
    }
}
