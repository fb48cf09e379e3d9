using System.Collections;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Plays scenes one after the other, each at rising speeds until it fails; the table is written after every run.</summary>
    public sealed class LeakSession : JobSession
    {
        readonly LeakArguments arguments;
        readonly FluidShaderSet shaders;
        readonly ResultTable<LeakResult> table;

        /// <summary>Prepares a session; nothing is played yet.</summary>
        /// <param name="arguments">What to play.</param>
        /// <param name="shaders">The package's shaders.</param>
        /// <param name="progress">Where it says how far it is.</param>
        /// <exception cref="FluidDeviceException">There are no shaders.</exception>
        /// <exception cref="CommandLineException">The output folder cannot be written, or holds another file of the table's name.</exception>
        public LeakSession(LeakArguments arguments, FluidShaderSet shaders, SessionProgress progress)
            : base(arguments, "scenes", SystemInfo.graphicsDeviceName, progress, new SessionRate(null))
        {
            this.arguments = arguments;
            this.shaders = SessionAssets.Require(shaders, "The leak scenes have");
            table = new ResultTable<LeakResult>(LeakResult.Format, Folder, SystemInfo.graphicsDeviceName);
            Claim(new[] { LeakResult.Format.File });
        }

        private protected override bool Resumes => false;

        private protected override IEnumerable<SessionJob> Jobs() =>
            arguments.Scenes.Select(s => new SessionJob(s.Name, s.Speeds.Count, () => false, () => Play(s)));

        IEnumerator Play(LeakSceneEntry entry)
        {
            bool failed = false;
            foreach (double speed in entry.Speeds.TakeWhile(_ => !failed))
            {
                using (var run = new LeakRun(entry.Build(speed), shaders))
                {
                    yield return run.Run();
                    table.Add(run.Result);
                    failed = run.Result.Failure.Length > 0;
                    Progress.Say(run.Result.ToString());
                }
            }
        }
    }
}
