using System;
using UnityEditor;

namespace SphFluid.Validation.Editor
{
    /// <summary>
    /// Window > SPH Fluid > Stability Maps: where the methods are stable on this machine, the same code as the command line's.
    /// </summary>
    public static class StabilityMenu
    {
        private const string Path = "Window/SPH Fluid/Stability Maps";

        private static readonly MenuSession session =
            new MenuSession(progress => new StabilitySession(StabilityArguments.Parse(Array.Empty<string>()),
                SessionAssets.PackageShaders, progress));

        /// <summary>Starts all maps, or stops those that run; it goes on from what is in Build/stability already.</summary>
        [MenuItem(Path, false, 3012)]
        public static void Toggle() => session.Toggle();
    }
}
