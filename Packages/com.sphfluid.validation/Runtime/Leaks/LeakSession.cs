using System;
using System.Collections;
using System.Globalization;
using System.Linq;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Plays scenes one after the other, each at rising speeds until it fails; the table is written after every run.</summary>
    public sealed class LeakSession : IValidationSession
    {
        readonly LeakArguments arguments;
        readonly FluidShaderSet shaders;
        readonly SessionProgress progress;
        readonly LeakTable table;
        readonly SessionWork work;
        readonly ResultFolder results;

        /// <summary>Prepares a session; nothing is played yet.</summary>
        /// <param name="arguments">What to play.</param>
        /// <param name="shaders">The package's shaders.</param>
        /// <param name="progress">Where it says how far it is.</param>
        /// <exception cref="FluidDeviceException">There are no shaders.</exception>
        /// <exception cref="CommandLineException">The output folder cannot be written, or holds another file of the table's name.</exception>
        public LeakSession(LeakArguments arguments, FluidShaderSet shaders, SessionProgress progress)
        {
            this.arguments = arguments;
            this.shaders = SessionAssets.Require(shaders, "The leak scenes have");
            this.progress = progress;
            results = ResultFolder.Open(arguments.OutputFolder, new[] { ResultFile.Table(LeakTable.FileName, LeakTable.Columns) });
            table = new LeakTable(arguments.OutputFolder, SystemInfo.graphicsDeviceName);
            work = new SessionWork(Run());
        }

        /// <inheritdoc/>
        public bool Step() => work.Step();

        /// <summary>Frees the GPU memory; the table holds every finished run.</summary>
        public void Dispose()
        {
            work.Clear();
            results.Close();
        }

        IEnumerator Run()
        {
            foreach (LeakScenes scenes in arguments.Scenes)
            {
                bool failed = false;
                foreach (double speed in scenes.Speeds.TakeWhile(_ => !failed))
                {
                    using (var run = new LeakRun(scenes.Build(speed), shaders))
                    {
                        yield return run.Run();
                        table.Add(run.Result);
                        failed = run.Result.Failure.Length > 0;
                        progress.Say(Line(run.Result));
                    }
                }
            }
        }

        static string Line(LeakResult result)
        {
            string speed = result.Scene.Speed > 0.0 ? string.Format(CultureInfo.InvariantCulture, " at {0:G4} m/s", result.Scene.Speed) : "";
            string end = result.Failure.Length == 0 ? "holds" : "fails: " + result.Failure;
            return $"{result.Scene.Name}{speed}: {end}; {result.Escapes} escapes of {result.Scene.Particles.Length} particles in {result.Steps} steps.";
        }
    }
}
