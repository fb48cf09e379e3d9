using System;
using System.IO;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Runs a benchmark in play mode, a step a frame, and ends the program with it.</summary>
    [AddComponentMenu("")]
    sealed class BenchDriver : MonoBehaviour
    {
        const int FailureExitCode = 1;

        BenchSession session;

        public static void Begin(BenchSession session)
        {
            var holder = new GameObject("Fluid Benchmark") { hideFlags = HideFlags.HideAndDontSave };
            holder.AddComponent<BenchDriver>().session = session;
        }

        void Update()
        {
            try
            {
                if (!session.Step())
                    Application.Quit(0);
            }
            catch (Exception exception) when (IsExpected(exception))
            {
                Console.Error.WriteLine(exception.Message);
                Application.Quit(FailureExitCode);
            }
            catch
            {
                Application.Quit(FailureExitCode);
                throw;
            }
        }

        void OnDestroy() => session?.Dispose();

        /// <summary>What a device or a disk can do to a benchmark; the message tells the user all.</summary>
        public static bool IsExpected(Exception exception) =>
            exception is FluidDeviceException || exception is IOException || exception is UnauthorizedAccessException;
    }
}
