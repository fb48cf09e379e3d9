using UnityEditor;
using UnityEngine;

namespace SphFluid.Editor
{
    /// <summary>
    /// What a step costs on this machine's graphics device, as it was measured in play and is kept in the Editor's preferences: by device, method and
    /// number of particles, in powers of two, as few particles leave a device idle.
    /// </summary>
    static class StepCost
    {
        const string Root = "SPH Fluid/Step cost/";
        const int Sizes = 32;

        /// <summary>Takes in a measurement.</summary>
        /// <param name="method">The method.</param>
        /// <param name="particles">Number of particles, 1 or more.</param>
        /// <param name="nanoseconds">GPU time of a step over that number [ns].</param>
        public static void Note(FluidMethodKind method, long particles, double nanoseconds)
        {
            if (particles < 1 || !(nanoseconds > 0.0) || double.IsInfinity(nanoseconds)) return;
            EditorPrefs.SetFloat(Key(method, SizeOf(particles)), (float)nanoseconds);
        }

        /// <summary>What was measured with the number of particles that is nearest.</summary>
        /// <param name="method">The method.</param>
        /// <param name="particles">Number of particles, 1 or more.</param>
        /// <param name="nanoseconds">GPU time of a step over the number of particles [ns].</param>
        /// <param name="measuredWith">About how many particles the liquid had that was measured.</param>
        /// <returns>False where nothing was measured on this device.</returns>
        public static bool TryFind(FluidMethodKind method, long particles, out double nanoseconds, out long measuredWith)
        {
            int size = SizeOf(particles);
            for (int away = 0; away < Sizes; away++)
            {
                foreach (int near in new[] { size + away, size - away })
                {
                    if (near < 0 || !EditorPrefs.HasKey(Key(method, near))) continue;
                    (nanoseconds, measuredWith) = (EditorPrefs.GetFloat(Key(method, near)), 1L << near);
                    return true;
                }
            }
            (nanoseconds, measuredWith) = (0.0, 0L);
            return false;
        }

        /// <summary>Forgets what was measured on this device.</summary>
        internal static void Forget()
        {
            foreach (FluidMethod method in FluidMethods.All)
                for (int size = 0; size < Sizes; size++) EditorPrefs.DeleteKey(Key(method.Kind, size));
        }

        static int SizeOf(long particles) => Mathf.Clamp(Mathf.RoundToInt(Mathf.Log(Mathf.Max(1f, particles), 2f)), 0, Sizes - 1);

        static string Key(FluidMethodKind method, int size) => $"{Root}{SystemInfo.graphicsDeviceName}/{method}/{size}";
    }
}
