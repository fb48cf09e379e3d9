using System;
using System.IO;
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
        private const int UsageExitCode = 2;
        internal const int FailureExitCode = 1;

        /// <summary>
        /// Prepares a play: the flags --method, --surface, --particles and --seed change every simulation of the scene
        /// that is loaded next; --state, --mesh and --record write files when the program quits, and the liquid's part of
        /// timings.csv and summary.json is added in the folder of --out. A wrong flag ends the program with exit code 2.
        /// In the Unity Editor the scene is given by --scene, its length by --seconds and --fps.
        /// </summary>
        public static void Play()
        {
            try
            {
                string[] commandLine = Environment.GetCommandLineArgs();
                PlayArguments arguments = PlayArguments.Parse(commandLine);
#if UNITY_EDITOR
                if (!Application.isPlaying)
                {
                    EditorPlay.Enter(commandLine);
                    return;
                }
#endif
                Prepare(arguments);
            }
            catch (CommandLineException exception)
            {
                Fail("play", exception.Message);
            }
        }

        /// <summary>
        /// Measures the tables of the thesis, the methods' steps or the surfaces against each other, on this device: the flags --table,
        /// --particles, --grids, --repeat, --out, --sweep and --no-sweep; see <see cref="BenchArguments"/>. The program ends with it. A
        /// wrong flag ends it with exit code 2.
        /// </summary>
        public static void Bench() =>
            Measure("bench", (words, progress) => new BenchSession(BenchArguments.Parse(words), SessionAssets.FindShaders(), progress));

        /// <summary>
        /// Measures the accuracy chart: the flags --quick, --case, --method, --out, --slice and --shard; see <see cref="ChartArguments"/>.
        /// The program ends with it. A wrong flag, or a folder with another device's chart, ends it with exit code 2.
        /// </summary>
        public static void Chart() =>
            Measure("chart", (words, progress) => new ChartSession(ChartArguments.Parse(words), SessionAssets.FindShaders(), progress));

        /// <summary>
        /// Answers which method, κ and spacing a flow needs for an error or a time, from a chart of this device: the flags --case, --error,
        /// --ms, --fps, --length, --speed, --volume, --compression, --chart, --verify and --out; see <see cref="ChooseArguments"/>. The
        /// program ends with it. A wrong flag, or a question that no chart answers, ends it with exit code 2.
        /// </summary>
        public static void Choose() =>
            Measure("choose", (words, progress) => new ChooseSession(ChooseArguments.Parse(words), SessionAssets.FindShaders(), progress));

        /// <summary>
        /// Measures where the methods are stable: the flags --quick, --map, --method, --out, --slice and --shard; see
        /// <see cref="StabilityArguments"/>. The program ends with it. A wrong flag, or a folder with another device's maps, ends it with
        /// exit code 2.
        /// </summary>
        public static void Stability() =>
            Measure("stability",
                (words, progress) => new StabilitySession(StabilityArguments.Parse(words), SessionAssets.FindShaders(), progress));

        /// <summary>
        /// Plays the scenes that nothing may leak from: the flags --scene, --out and --shard; see <see cref="LeakArguments"/>. The program
        /// ends with it. A wrong flag ends it with exit code 2.
        /// </summary>
        public static void Leaks() =>
            Measure("leaks", (words, progress) => new LeakSession(LeakArguments.Parse(words), SessionAssets.FindShaders(), progress));

        /// <summary>
        /// Measures how good surfaces of known liquids are: the flags --quick, --state, --variant, --out and --shard; see
        /// <see cref="SurfaceArguments"/>. The program ends with it. A wrong flag ends it with exit code 2.
        /// </summary>
        public static void Surfaces() =>
            Measure("surfaces",
                (words, progress) => new SurfaceSession(SurfaceArguments.Parse(words), SessionAssets.FindShaders(), progress));

        /// <summary>
        /// Puts the folders of a sweep's shards together: their names and the flags --errors-only and --out behind a lone <c>--</c>; see
        /// <see cref="MergeArguments"/>. The program ends with it. Folders that are not of one sweep end it with exit code 2, runs that no
        /// folder has with exit code 1.
        /// </summary>
        public static void Merge() => Measure("merge", (words, progress) => new MergeSession(MergeArguments.Parse(words), progress));

        /// <summary>
        /// Plays a liquid by every way that the method Automatic has, and as it picks for each budget: the flags --budget, --particles,
        /// --repeat and --out; see <see cref="BudgetArguments"/>. In play mode only. The program ends with it. A wrong flag ends it with
        /// exit code 2.
        /// </summary>
        public static void Budgets() =>
            Measure("budgets", (words, progress) => new BudgetSession(BudgetArguments.Parse(words), SessionAssets.FindShaders(), progress));

        /// <summary>
        /// Writes the liquids of a scene as cases of PySPH, with the motion of colliders while the scene plays without them: the flags
        /// --scene, --engine, --scheme, --seconds, --frame-rate, --spacing, --particles, --ranks, --strict and --out; see
        /// <see cref="ExportArguments"/>. The program ends with it: with exit code 1 where a liquid could not be exported, which leaves the
        /// others written, and with 2 for a wrong flag. In the Unity Editor outside play mode colliders are exported where the scene has
        /// them.
        /// </summary>
        public static void Export()
        {
            try
            {
                ExportArguments arguments = ExportArguments.Parse(Environment.GetCommandLineArgs());
#if UNITY_EDITOR
                if (!Application.isPlaying)
                {
                    UnityEditor.SceneManagement.EditorSceneManager.OpenScene(arguments.Scene);
                    ExportPlay.WriteOpenScene(arguments, EndExport);
                    return;
                }
#endif
                ExportPlay.Begin(arguments, EndExport);
            }
            catch (CommandLineException exception)
            {
                Fail("export", exception.Message);
            }
        }

        /// <summary>
        /// Gives cases of the chart to PySPH and compares its errors and times with the chart's: the flags --quick, --case, --python,
        /// --chart, --out and --slice; see <see cref="PeerArguments"/>. The program ends with it. A wrong flag, or PySPH that is missing,
        /// ends it with exit code 2.
        /// </summary>
        public static void Peers() => Measure("peers", (words, progress) => new PeerSession(PeerArguments.Parse(words), progress));

        internal static void Prepare(PlayArguments arguments)
        {
            bool begun = false;
            SceneManager.sceneLoaded += (scene, mode) =>
            {
                FluidSimulation.StartWatcher = new ConsoleStartWatcher(SessionProgress.OfConsole());
                try
                {
                    PlayOverrides.Apply(arguments, FluidSimulation.Active);
                }
                catch (CommandLineException exception)
                {
                    Fail("play", exception.Message);
                    return;
                }
                if (!begun) PlayRecorder.Begin(arguments);
                begun = true;
            };
        }

        // A step a frame until the measurement is done; in the Editor outside play mode by its own update.
        private static void Measure(string verb, Func<string[], SessionProgress, IValidationSession> create)
        {
            try
            {
                SessionProgress progress = Application.isEditor ? new SessionProgress(Debug.Log, null) : SessionProgress.OfConsole();
                IValidationSession session = create(Environment.GetCommandLineArgs(), progress);
#if UNITY_EDITOR
                if (!Application.isPlaying)
                {
                    EditorSession.Begin(session);
                    return;
                }
#endif
                SessionDriver.Begin(session);
            }
            catch (CommandLineException exception)
            {
                Fail(verb, exception.Message);
            }
            catch (Exception exception) when (exception is IOException || exception is UnauthorizedAccessException)
            {
                Fail(verb, "--out cannot be written: " + exception.Message);
            }
            catch (FluidDeviceException exception)
            {
                Fail(verb, exception.Message, FailureExitCode);
            }
        }

        private static void EndExport(string message, int exitCode) => Fail("export", message, exitCode);

        internal static void Fail(string verb, string message, int exitCode = UsageExitCode)
        {
            if (message != null) Console.Error.WriteLine(verb + ": " + message);
#if UNITY_EDITOR
            UnityEditor.EditorApplication.Exit(exitCode);
#else
            Application.Quit(exitCode);
#endif
        }
    }
}
