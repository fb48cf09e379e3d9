using System;
using SphFluid.Validation;
using UnityEditor;
using UnityEngine;

namespace SphFluid.Editor
{
    /// <summary>Window > SPH Fluid > Benchmark: the thesis's tables on this machine, the same code as the command line's.</summary>
    public static class BenchMenu
    {
        const string Path = "Window/SPH Fluid/Benchmark";

        static BenchSession session;

        /// <summary>Starts the benchmark with the command line's defaults, or stops the one that runs; it goes on while the Editor is used.</summary>
        [MenuItem(Path, false, 3010)]
        public static void Toggle()
        {
            if (session != null)
            {
                End();
                return;
            }
            try
            {
                BenchArguments arguments = BenchArguments.Parse(Array.Empty<string>());
                session = new BenchSession(arguments, PackageAssets.Shaders, new BenchProgress(text => Debug.Log($"{FluidMessage.Prefix} {text}"), null));
                EditorApplication.update += Step;
            }
            catch (FluidDeviceException exception)
            {
                Debug.LogError($"{FluidMessage.Prefix} {exception.Message}");
            }
        }

        static void Step()
        {
            try
            {
                if (!session.Step())
                    End();
            }
            catch (Exception exception)
            {
                Debug.LogException(exception);
                End();
            }
        }

        static void End()
        {
            EditorApplication.update -= Step;
            session.Dispose();
            session = null;
        }
    }
}
