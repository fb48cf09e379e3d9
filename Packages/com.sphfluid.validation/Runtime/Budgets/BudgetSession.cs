using System.Collections;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// Plays the same liquid by every given way and as Automatic picks it for every budget, in turns, and holds the picks against what the
    /// given ways did at the same cost. In play mode only: it plays components.
    /// </summary>
    public sealed class BudgetSession : JobSession
    {
        private readonly BudgetArguments arguments;
        private readonly FluidShaderSet shaders;
        private readonly ResultTable<BudgetRow> table;
        private BudgetRun running;

        /// <summary>Prepares a session; nothing is played yet.</summary>
        /// <param name="arguments">What to play.</param>
        /// <param name="shaders">The package's shaders.</param>
        /// <param name="progress">Where it says how far it is.</param>
        /// <exception cref="FluidDeviceException">There are no shaders.</exception>
        /// <exception cref="CommandLineException">It is not play mode, or the output folder cannot be written or holds another file of the
        /// table's name.</exception>
        public BudgetSession(BudgetArguments arguments, FluidShaderSet shaders, SessionProgress progress)
            : base(arguments, "runs", SystemInfo.graphicsDeviceName, progress, new SessionRate(null))
        {
            if (!Application.isPlaying)
            {
                throw new CommandLineException(
                    "budgets plays Fluid Simulations, which run in play mode only. Enter play mode first, or use a built player.");
            }
            this.arguments = arguments;
            this.shaders = SessionAssets.Require(shaders, "The runs of budgets have");
            table = new ResultTable<BudgetRow>(BudgetRow.Format, Folder, SystemInfo.graphicsDeviceName);
            Claim(new[] { BudgetRow.Format.File });
        }

        private protected override bool Resumes => false;

        private protected override IEnumerable<SessionJob> Jobs()
        {
            var ways = new List<BudgetWay> { BudgetWay.Reference };
            ways.AddRange(BudgetWay.Given);
            ways.AddRange(arguments.Budgets.Select(BudgetWay.Chosen));
            return from particles in arguments.Particles
                   from seed in Enumerable.Range(1, arguments.Repeats)
                   from way in ways
                   select Job(way, particles, seed);
        }

        private protected override void Draw()
        {
            foreach (IGrouping<double, BudgetRow> liquid in table.Rows.GroupBy(r => r.Spacing)) BudgetVerdict.Judge(liquid.ToArray());
            table.Write();
            foreach (BudgetRow row in table.Rows.Where(r => r.BetterWay.Length > 0 && r.Seed == 1))
            {
                Progress.Say($"With {row.Particles} particles {row.Way.Name} is worse than {row.BetterWay} at the same cost.");
            }
        }

        private SessionJob Job(BudgetWay way, int particles, int seed) => new SessionJob($"{way.Name}, {particles} particles, seed {seed}",
            particles * (way == BudgetWay.Reference ? 2.0 : 1.0), () => false, () => Play(way, particles, seed),
            share: () => running?.Share ?? 0.0);

        private IEnumerator Play(BudgetWay way, int particles, int seed)
        {
            using (running = new BudgetRun(way, particles, seed, shaders))
            {
                yield return running.Run();
                table.Add(running.Row);
            }
            running = null;
        }
    }
}
