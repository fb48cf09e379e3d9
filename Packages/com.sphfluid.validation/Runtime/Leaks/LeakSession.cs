using System.Collections;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Plays scenes one after the other, each at rising speeds until it fails; the table is written after every run.</summary>
    public sealed class LeakSession : JobSession
    {
        private readonly LeakArguments arguments;
        private readonly FluidShaderSet shaders;
        private readonly ResultTable<LeakResult> table;
        private LeakRun running;
        private double played, costOfRun;

        /// <summary>Prepares a session; nothing is played yet.</summary>
        /// <param name="arguments">What to play.</param>
        /// <param name="shaders">The package's shaders.</param>
        /// <param name="progress">Where it says how far it is.</param>
        /// <exception cref="FluidDeviceException">There are no shaders.</exception>
        /// <exception cref="CommandLineException">The output folder cannot be written, or holds another file of the table's
        /// name.</exception>
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
            arguments.Scenes.Select(s => Job(s, s.Speeds.Select(speed => LeakRun.CostOf(s.Build(speed))).ToArray()));

        private protected override IEnumerator Begin() => Calibrate(shaders, LeakRun.CostOfStep);

        private SessionJob Job(LeakSceneEntry entry, double[] costs)
        {
            double all = costs.Sum();
            return new SessionJob(entry.Name, all, () => false, () => Play(entry, costs),
                share: () => (played + (running?.Share ?? 0.0) * costOfRun) / all,
                key: ShardedTable.RunKey(LeakResult.Format, entry.Name));
        }

        // All speeds count as played: few scenes fail at any.
        private IEnumerator Play(LeakSceneEntry entry, double[] costs)
        {
            bool failed = false;
            played = 0.0;
            for (int i = 0; i < entry.Speeds.Count && !failed; i++)
            {
                using (var run = new LeakRun(entry.Build(entry.Speeds[i]), shaders))
                {
                    (running, costOfRun) = (run, costs[i]);
                    yield return run.Run();
                    running = null;
                    played += costs[i];
                    table.Add(run.Result);
                    failed = run.Result.Failure.Length > 0;
                    Progress.Say(run.Result.ToString());
                }
            }
        }
    }
}
