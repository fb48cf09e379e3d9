using System;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace SphFluid.Validation
{
    /// <summary>
    /// Entry points for Unity's <c>-batchmode -executeMethod SphFluid.Validation.CommandLine.Play</c>. They read the
    /// liquid's flags from the command line of the process.
    /// </summary>
    public static class CommandLine
    {
        const int UsageExitCode = 2;

        /// <summary>
        /// Prepares a play: the flags --method, --surface, --particles and --seed change every simulation of the scene
        /// that is loaded next; --state, --mesh and --record write files when the program quits, and the liquid's part of
        /// timings.csv and summary.json is added in the folder of --out. A wrong flag ends the program with exit code 2.
        /// </summary>
        public static void Play()
        {
            PlayArguments arguments;
            try
            {
                arguments = PlayArguments.Parse(Environment.GetCommandLineArgs());
            }
            catch (CommandLineException exception)
            {
                Console.Error.WriteLine(exception.Message);
                Application.Quit(UsageExitCode);
                return;
            }
            SceneManager.sceneLoaded += Prepare;
            PlayRecorder.Begin(arguments);

            void Prepare(Scene scene, LoadSceneMode mode) => PlayOverrides.Apply(arguments, FluidSimulation.Active);
        }
    }
}
