using UnityEditor;

namespace SphFluid.Validation.Editor
{
    /// <summary>
    /// Window > SPH Fluid > Benchmark: the tables on this machine, the same code as the command line's, with its defaults.
    /// </summary>
    public static class BenchMenu
    {
        private const string Path = "Window/SPH Fluid/Benchmark/";

        private static readonly MenuSession thesis = Session(BenchArguments.ThesisTable);
        private static readonly MenuSession solver = Session(BenchArguments.SolverTable);
        private static readonly MenuSession surface = Session(BenchArguments.SurfaceTable);

        /// <summary>Starts the thesis's tables, or stops them; the Editor can be used meanwhile.</summary>
        [MenuItem(Path + "Thesis Tables", false, 3010)]
        public static void ToggleThesis() => thesis.Toggle();

        /// <summary>Starts the comparison of the methods' steps, or stops it; the Editor can be used meanwhile.</summary>
        [MenuItem(Path + "Solvers", false, 3011)]
        public static void ToggleSolver() => solver.Toggle();

        /// <summary>Starts the comparison of the surfaces, or stops it; the Editor can be used meanwhile.</summary>
        [MenuItem(Path + "Surfaces", false, 3012)]
        public static void ToggleSurface() => surface.Toggle();

        private static MenuSession Session(string table) =>
            new MenuSession(progress => new BenchSession(BenchArguments.Parse(new[] { "--", "--table", table }),
                SessionAssets.PackageShaders, progress));
    }
}
