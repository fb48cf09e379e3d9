using System;
using UnityEditor;

namespace SphFluid.Validation.Editor
{
    /// <summary>
    /// Window > SPH Fluid > Accuracy Chart: the error of each case against its time on this machine, the same code as the command line's.
    /// </summary>
    public static class ChartMenu
    {
        private const string Path = "Window/SPH Fluid/Accuracy Chart";

        private static readonly MenuSession session =
            new MenuSession(progress => new ChartSession(ChartArguments.Parse(Array.Empty<string>()),
                SessionAssets.PackageShaders, progress));

        /// <summary>Starts the whole chart, or stops the one that runs; it goes on from what is in Build/chart already.</summary>
        [MenuItem(Path, false, 3011)]
        public static void Toggle() => session.Toggle();
    }
}
