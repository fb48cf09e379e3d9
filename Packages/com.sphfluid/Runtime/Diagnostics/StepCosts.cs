using System;
using System.IO;
using System.Text;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// What steps cost on this machine's graphics device, kept in a file of the application's temporary cache, in the Editor and in builds.
    /// Costs of another device, driver or version of the package are not used.
    /// </summary>
    internal static class StepCosts
    {
        /// <summary>
        /// Time of a pass over a particle and its neighbours where a device cannot be timed [ns]: what no device was measured for, and weak
        /// ones need.
        /// </summary>
        public const double EstimatedPass = 5.0;

        private const int MostBytes = 1 << 20;

        private static StepCostTable table;
        [OutlivesPlay("what tests have set")] private static bool isKept = true;

        /// <summary>Grows with every cost that is noted or forgotten.</summary>
        [OutlivesPlay("it is only compared")] public static int Revision { get; private set; }

        /// <summary>Takes in a measurement.</summary>
        /// <param name="key">Of which steps it is.</param>
        /// <param name="cost">What was measured; numbers that are none of a measurement are passed over.</param>
        public static void Record(in StepCostKey key, in StepCost cost)
        {
            if (Table.Record(key, cost)) Keep();
        }

        /// <summary>The cost of a step with a number of particles.</summary>
        /// <returns>False where nothing is known of such steps on this device.</returns>
        public static bool TryFind(in StepCostKey key, long particles, out StepCost cost) => Table.TryFind(key, particles, out cost);

        /// <summary>Forgets what is known of some steps, so that they are measured anew.</summary>
        public static void Forget(in StepCostKey key)
        {
            Table.Forget(key);
            Keep();
        }

        /// <summary>Time of a step where the device cannot be timed [ms].</summary>
        public static double Estimate(FluidMethodKind method, long particles) =>
            1e-6 * EstimatedPass * FluidMethods.Get(method).PassesAStep * particles;

        /// <summary>Puts another table in the place of the present one, which is not kept; for tests.</summary>
        /// <param name="other">The table; null: the kept one again.</param>
        internal static void Use(StepCostTable other)
        {
            (table, isKept) = (other, other == null);
            Revision++;
        }

        /// <summary>A table as it is kept.</summary>
        internal static string Pack(StepCostTable costs) => $"{Head}\n{costs.ToText()}";

        /// <summary>The table of a kept text; an empty one where the text is of another device, driver or version.</summary>
        internal static StepCostTable Unpack(string text) =>
            text.StartsWith(Head + "\n", StringComparison.Ordinal) ? StepCostTable.Parse(text.Substring(Head.Length + 1))
                : new StepCostTable();

        private static StepCostTable Table => table ??= Unpack(Read());

        // A file for each device, whose name may hold what a file's must not.
        private static string Path => System.IO.Path.Combine(Application.temporaryCachePath,
            $"SPH Fluid step costs {Crc32.Compute(Encoding.UTF8.GetBytes(SystemInfo.graphicsDeviceName)):x8}.txt");

        private static string Head => $"{FluidPackage.Version}|{SystemInfo.graphicsDeviceName}|{SystemInfo.graphicsDeviceVersion}";

        private static void Keep()
        {
            Revision++;
            if (!isKept) return;
            try
            {
                File.WriteAllText(Path, Pack(Table));
            }
            catch (Exception exception) when (exception is IOException || exception is UnauthorizedAccessException)
            {
                // Platforms without files measure again in the next session.
            }
        }

        private static string Read()
        {
            try
            {
                var kept = new FileInfo(Path);
                return kept.Exists && kept.Length <= MostBytes ? File.ReadAllText(Path) : "";
            }
            catch (Exception exception) when (exception is IOException || exception is UnauthorizedAccessException)
            {
                return "";
            }
        }

        // Without a domain reload statics outlive play mode, and another device may be in use by then.
        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        private static void ResetStatics()
        {
            if (isKept) table = null;
        }
    }
}
