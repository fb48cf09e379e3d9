using System;
using SphFluid.Validation;
using UnityEditor;

namespace SphFluid.Editor
{
    /// <summary>Window > SPH Fluid > Benchmark: the thesis's tables on this machine, the same code as the command line's.</summary>
    public static class BenchMenu
    {
        const string Path = "Window/SPH Fluid/Benchmark";

        static readonly MenuSession session =
            new MenuSession(progress => new BenchSession(BenchArguments.Parse(Array.Empty<string>()), PackageAssets.Shaders, progress));

        /// <summary>Starts the benchmark with the command line's defaults, or stops the one that runs; it goes on while the Editor is used.</summary>
        [MenuItem(Path, false, 3010)]
        public static void Toggle() => session.Toggle();
    }
}
