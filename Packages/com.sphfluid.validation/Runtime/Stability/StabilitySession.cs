using System;
using System.Collections;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Runs the cells of the maps, bisects the borders and draws; the tables are written after every run.</summary>
    public sealed class StabilitySession : JobSession
    {
        /// <summary>Makes the work of a run, which hands over its result.</summary>
        internal delegate IEnumerator Runner(CaseSetup setup, CaseMetric metric, Action<CaseResult> done);

        private readonly FluidShaderSet shaders; // null for runs that are made up
        private readonly StabilityPlan plan;
        private readonly Runner runner;
        private readonly ResultTable<StabilityRow> table;
        private readonly ResultTable<LimitRow> limits;

        /// <summary>Prepares a session; nothing is run yet.</summary>
        /// <param name="arguments">What to measure.</param>
        /// <param name="shaders">The package's shaders.</param>
        /// <param name="progress">Where it says how far it is.</param>
        /// <exception cref="CommandLineException">The folder has tables that cannot be continued.</exception>
        /// <exception cref="FluidDeviceException">There are no shaders.</exception>
        public StabilitySession(StabilityArguments arguments, FluidShaderSet shaders, SessionProgress progress)
            : this(arguments, StabilityPlan.Of(arguments, FluidSupport.IsSoftwareDevice), RunnerOf(shaders), progress,
                SystemInfo.graphicsDeviceName)
        {
            this.shaders = shaders;
        }

        internal StabilitySession(StabilityArguments arguments, StabilityPlan plan, Runner runner, SessionProgress progress, string device)
            : base(arguments, "runs and borders", device, progress, new SessionRate(null))
        {
            this.plan = plan;
            this.runner = runner;
            table = ResultTable<StabilityRow>.Resume(StabilityRow.Format, Folder, device, () => new StabilityRow());
            limits = ResultTable<LimitRow>.Resume(LimitRow.Format, Folder, device, () => new LimitRow());
            Claim(Files);
        }

        /// <summary>All files of the maps and borders.</summary>
        internal static IEnumerable<ResultFile> Files =>
            new[] { StabilityRow.Format.File, LimitRow.Format.File }.Concat(StabilityMap.All.SelectMany(StabilityScript.Files));

        /// <summary>A session that draws the maps whose tables its folder has, and runs nothing.</summary>
        /// <param name="arguments">What was measured.</param>
        /// <param name="device">The device of the tables.</param>
        /// <param name="progress">Where it says what it writes.</param>
        internal static StabilitySession OfTables(StabilityArguments arguments, string device, SessionProgress progress) =>
            new StabilitySession(arguments, null, null, progress, device) { OnlyDraws = true };

        private protected override IEnumerable<SessionJob> Jobs() =>
            plan.Runs.Select(Cell).Concat(plan.Limits.Select(l => Border(l.Limit, l.Method))).Concat(plan.Clamped.Select(Cell));

        private protected override IEnumerator Begin()
        {
            if (shaders != null) yield return Calibrate(shaders, StabilityRun.CostOfStep);
        }

        private protected override void Draw()
        {
            IEnumerable<StabilityScript> scripts = from map in StabilityMap.All
                                                   from clamps in new[] { false, true }
                                                   let rows = table.Rows.Where(r => r.Map == map.Name && r.Clamps == clamps).ToList()
                                                   where rows.Count > 0
                                                   select new StabilityScript(map, rows, clamps);
            string problem = GnuplotScript.Draw(Folder, scripts);
            Progress.Say(problem ??
                $"{StabilityRow.Format.FileName}, {LimitRow.Format.FileName} and a picture a map, stability-m1.png and so on, are in " +
                $"'{Folder}'.");
        }

        private static Runner RunnerOf(FluidShaderSet shaders)
        {
            SessionAssets.Require(shaders, "The stability maps have");
            return (setup, metric, done) => RunOnGpu(setup, metric, shaders, done);
        }

        private static IEnumerator RunOnGpu(CaseSetup setup, CaseMetric metric, FluidShaderSet shaders, Action<CaseResult> done)
        {
            using (var run = new CaseRun(setup, metric, shaders))
            {
                yield return run.Run();
                done(run.Result);
            }
        }

        private SessionJob Cell(StabilityRun run) =>
            new SessionJob(run.ToString(), run.Cost, () => table.Contains(run.Key), () => RunCell(run),
            key: ShardedTable.RunKey(StabilityRow.Format, run.Key));

        private SessionJob Border(StabilityLimit limit, CaseMethod method)
        {
            const double trials = 10.0;
            CaseSetup setup = limit.Build(limit.TheoryLow, method);
            double cost = trials * setup.Duration / setup.Settings.TimeStep * StabilityRun.CostOfStep(setup.Particles.Length);
            string key = LimitRow.KeyOf(limit.Name, method.Name, limit.SupportRatio);
            return new SessionJob($"border {limit}, {method.Name}", cost, () => limits.Contains(key), () => Bisect(limit, method),
                key: ShardedTable.RunKey(LimitRow.Format, key));
        }

        private IEnumerator RunCell(StabilityRun run)
        {
            StabilityScenario scene = run.Build();
            var criterion = new StabilityCriterion(scene);
            CaseResult result = null;
            yield return runner(scene.Setup, criterion, r => result = r);
            double share = scene.Setup.Duration / scene.RequestedDuration;
            string cut = scene.IsCut
                ? FormattableString.Invariant($"{StabilityScenario.CutText} of {result.Steps} steps at {share:P0} of ") +
                    FormattableString.Invariant($"{scene.RequestedDuration:G3} s")
                : "";
            table.Add(new StabilityRow(run, criterion.Conclude(result, cut)));
            if (run.X.Equals(run.Map.X.High)) Progress.Say(Line(run));
        }

        private IEnumerator Bisect(StabilityLimit limit, CaseMethod method)
        {
            Bisection search = limit.Search();
            while (!search.IsDone)
            {
                CaseResult result = null;
                CaseSetup setup = limit.Build(search.Next, method);
                yield return runner(setup, new GrowthMetric(limit.Growth, setup.Settings.PeriodLength), r => result = r);
                search.Add(!result.Failed);
            }
            var row = new LimitRow(limit, method, search);
            limits.Add(row);
            Progress.Say(string.Format(CultureInfo.InvariantCulture, "border {0}, {1}: {2:G4} to {3:G4}, theory {4:G4} to {5:G4}{6}", limit,
                method.Name,
                row.MeasuredLow, row.MeasuredHigh, row.TheoryLow, row.TheoryHigh, row.IsWithin ? "" : ", OUTSIDE 5 %"));
        }

        // A finished line of a map: "M1, thesis, c/√(gH) 10: ······EEV".
        private string Line(StabilityRun run)
        {
            IEnumerable<string> letters = table.Rows
                .Where(r => r.Map == run.Map.Name && r.Method == run.Method.Name && r.Clamps == run.Clamps && r.Seed == run.Seed &&
                    CsvText.Text(r.Y) == CsvText.Text(run.Y))
                .OrderBy(r => r.X).Select(r => r.Outcome.Cause == StabilityCause.None ? "·" : StabilityLegend.Letter(r.Outcome.Cause));
            return string.Format(CultureInfo.InvariantCulture, "{0}, {1}, {2} {3,5:G3}: {4}{5}", run.Map.Name, run.Method.Name,
                run.Map.Y.Title, run.Y,
                string.Concat(letters), run.Clamps ? "  (with clamps)" : "");
        }
    }
}
