using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace SphFluid.Validation
{
    /// <summary>
    /// Exports the liquids of a scene from the command line: as they start, with the motion that colliders have while the scene plays
    /// without them.
    /// </summary>
    internal sealed class ExportPlay
    {
        private readonly ExportArguments arguments;
        private readonly Action<string, int> fail;
        private bool loaded;

        private ExportPlay(ExportArguments arguments, Action<string, int> fail)
        {
            this.arguments = arguments;
            this.fail = fail;
        }

        /// <summary>In play mode: loads the scene, records and writes; the program ends with it.</summary>
        /// <param name="arguments">What is exported.</param>
        /// <param name="fail">Ends the program with a message and an exit code.</param>
        public static void Begin(ExportArguments arguments, Action<string, int> fail)
        {
            var export = new ExportPlay(arguments, fail);
            FluidSimulation.StartWatcher = new ConsoleStartWatcher(SessionProgress.OfConsole());
            Time.captureDeltaTime = (float)(1.0 / arguments.FrameRate);
            // Until then something must be there, or a player of an empty scene ends.
            var holder = new GameObject("Export");
            SceneManager.sceneLoaded += export.OnLoaded;
            AsyncOperation loading = SceneManager.LoadSceneAsync(arguments.Scene);
            if (loading == null)
                fail(null, 2);
            else
                loading.completed += _ => export.RequireLoaded(holder);
        }

        /// <summary>In the Editor outside play mode: writes the liquids of the open scenes; nothing moves.</summary>
        /// <param name="arguments">What is exported.</param>
        /// <param name="fail">Ends the program with a message and an exit code.</param>
        public static void WriteOpenScene(ExportArguments arguments, Action<string, int> fail)
        {
            var export = new ExportPlay(arguments, fail);
            FluidSimulation[] simulations = LoadedScenes.Find<FluidSimulation>().ToArray();
            if (!export.TryPrepare(simulations)) return;
            FluidExport[] exports = simulations.Select(s => FluidExport.Begin(s, export.Options)).ToArray();
            try
            {
                fail(null, export.Write(simulations, exports));
            }
            finally
            {
                foreach (FluidExport made in exports) made.Dispose();
            }
        }

        private FluidExportOptions Options => new FluidExportOptions
        {
            Seconds = arguments.Seconds,
            FrameRate = arguments.FrameRate,
            Scheme = arguments.Scheme,
            Ranks = arguments.Ranks,
            Scene = Path.GetFileNameWithoutExtension(arguments.Scene),
            Commit = SweepBuild.Commit,
        };

        // Loading says itself what is wrong with a scene.
        private void RequireLoaded(GameObject holder)
        {
            UnityEngine.Object.Destroy(holder);
            if (!loaded) fail(null, 2);
        }

        // Before the first frame, so that no liquid starts; its colliders move on.
        private void OnLoaded(Scene scene, LoadSceneMode mode)
        {
            loaded = true;
            SceneManager.sceneLoaded -= OnLoaded;
            FluidSimulation[] simulations = FluidSimulation.Active.ToArray();
            if (!TryPrepare(simulations)) return;
            foreach (FluidSimulation simulation in simulations) simulation.StopSimulation();
            FluidExportRecorder.Begin(simulations, Options, exports => Application.Quit(Write(simulations, exports)));
        }

        private bool TryPrepare(FluidSimulation[] simulations)
        {
            if (simulations.Length == 0)
            {
                fail($"--scene: '{CommandLineWords.Shown(arguments.Scene)}' has no Fluid Simulation that is enabled.", 2);
                return false;
            }
            foreach (FluidSimulation simulation in simulations)
            {
                if (arguments.Spacing is float spacing) simulation.Spacing = spacing;
                if (arguments.Particles is int count) Fit(simulation, count);
            }
            return true;
        }

        // One that holds no liquid keeps its spacing: it is not exported, and the others are.
        private static void Fit(FluidSimulation simulation, int count)
        {
            try
            {
                simulation.Spacing = simulation.SpacingForParticleCount(count);
            }
            catch (Exception exception) when (exception is InvalidOperationException || exception is ArgumentException)
            {
                Console.Error.WriteLine($"export: --particles: '{simulation.name}' keeps its spacing: {exception.Message}");
            }
        }

        // The exit code: 1 where a liquid could not be exported; the others are written all the same.
        private int Write(IReadOnlyList<FluidSimulation> simulations, IReadOnlyList<FluidExport> exports)
        {
            foreach (FluidExport export in exports)
                foreach (FluidMessage message in export.Messages) message.Log();
            if (arguments.Strict && exports.Any(e => e.LeavesOut || !e.HasLiquid))
            {
                Console.Error
                    .WriteLine(
                        "export: nothing is written, because --strict is given and the parts of the scene named above cannot be exported.");
                return 1;
            }
            try
            {
                string[] folders = FluidExport.FoldersOf(simulations, arguments.OutputFolder);
                for (int i = 0; i < exports.Count; i++)
                    if (exports[i].HasLiquid) WriteOne(exports[i], folders[i]);
                return exports.All(e => e.HasLiquid) ? 0 : 1;
            }
            catch (Exception exception) when (exception is IOException || exception is UnauthorizedAccessException)
            {
                Console.Error.WriteLine("export: --out: " + exception.Message);
                return 2;
            }
        }

        private static void WriteOne(FluidExport export, string folder)
        {
            long bytes = export.Write(folder);
            Console.WriteLine(FormattableString.Invariant(
                $"{export.ParticleCount} particles of liquid and {export.WallParticleCount} of walls, {bytes / 1e6:0.0} MB, in ") +
                FormattableString.Invariant($"{folder}. Run it: bash {Path.Combine(folder, "run.sh")}"));
        }
    }
}
