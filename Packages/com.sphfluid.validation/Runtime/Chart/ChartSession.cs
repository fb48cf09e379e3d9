using System;
using System.Collections;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Measures a chart run by run and draws it; the table is written after every run.</summary>
    public sealed class ChartSession : JobSession
    {
        /// <summary>Makes the work of a run, which hands over its result.</summary>
        internal delegate IEnumerator Runner(ChartRun run, Action<CaseResult> done);

        private readonly FluidShaderSet shaders; // null for runs that are made up
        private readonly ChartArguments arguments;
        private readonly Runner runner;
        private readonly ResultTable<ChartRow> table;
        private readonly ResultTable<StepCostRow> costs;
        private readonly ChartPlan plan;

        /// <summary>Prepares a chart; nothing is measured yet.</summary>
        /// <param name="arguments">What to measure.</param>
        /// <param name="shaders">The package's shaders.</param>
        /// <param name="progress">Where it says how far it is.</param>
        /// <exception cref="CommandLineException">The folder has a chart that cannot be continued.</exception>
        /// <exception cref="FluidDeviceException">The device has no GPU times.</exception>
        public ChartSession(ChartArguments arguments, FluidShaderSet shaders, SessionProgress progress)
            : this(arguments, PlanFor(arguments), new ChartRunner(shaders).Run, progress, SystemInfo.graphicsDeviceName,
                new SessionRate(null))
        {
            this.shaders = shaders;
        }

        internal ChartSession(ChartArguments arguments, ChartPlan plan, Runner runner, SessionProgress progress, string device,
            SessionRate rate)
            : base(arguments, "runs", device, progress, rate)
        {
            this.arguments = arguments;
            this.plan = plan;
            this.runner = runner;
            table = ResultTable<ChartRow>.Resume(ChartRow.Format, Folder, device, () => new ChartRow());
            costs = ResultTable<StepCostRow>.Resume(StepCostRow.Format, Folder, device, () => new StepCostRow());
            Claim(Files(arguments.Cases));
        }

        /// <summary>A session that draws the chart whose tables its folder has, and measures nothing.</summary>
        /// <param name="arguments">What was measured.</param>
        /// <param name="device">The device of the tables.</param>
        /// <param name="progress">Where it says what it writes.</param>
        internal static ChartSession OfTables(ChartArguments arguments, string device, SessionProgress progress) =>
            new ChartSession(arguments, null, null, progress, device, new SessionRate(null)) { OnlyDraws = true };

        private protected override IEnumerable<SessionJob> Jobs()
        {
            foreach (var same in plan.Unbuildable.GroupBy(c => (c.Case.Name, Method: c.Method.Name, c.Problem)))
            {
                Progress.Say(
                    $"Not part of the chart: {same.Count()} {(same.Count() == 1 ? "point" : "points")} of {same.Key.Name} with " +
                    $"{same.Key.Method}: {same.Key.Problem}");
            }
            string reason = arguments.Quick ? "they do not fit into the short plan's time"
                : "they take too long on this device, or do not fit into the chart's time";
            if (plan.LeftOut.Count > 0) Progress.Say($"{plan.LeftOut.Count} runs are left out, {reason}: {plan.DescribeLeftOut()}.");
            // A run each of every case and method comes first.
            int first = Math.Min(plan.Runs.Count, arguments.Cases.Count * arguments.Methods.Count);
            return plan.Runs.Take(first).Select(Job).Concat(plan.StepCosts.Select(Job)).Concat(plan.Runs.Skip(first).Select(Job));
        }

        private protected override IEnumerator Begin()
        {
            if (shaders != null) yield return Calibrate(shaders, StepWork.OfStandard);
        }

        private protected override void Draw()
        {
            SayBusy();
            WriteFits();
            new ChartDrawing(Folder, table, arguments.Cases, arguments.Command, Progress).Write();
        }

        // Cases that an earlier chart in the folder measured are fitted too.
        private void WriteFits()
        {
            if (table.Rows.Count == 0) return;
            var chart = new ChartData(Folder, table.Rows, costs.Rows);
            StepFitRow.Format.Write(Folder, StepFitRow.Of(chart));
            ErrorFitRow.Format.Write(Folder, ErrorFitRow.Of(chart, CaseCatalogue.All.Where(c => !c.IsGate).Union(arguments.Cases)));
        }

        private void SayBusy()
        {
            int busy = table.Rows.Where(r => r.TimeSpread > StepTimes.BusySpread).Select(r => r.Key).Distinct().Count() +
                costs.Rows.Count(r => r.Spread > StepTimes.BusySpread);
            if (busy > 0)
            {
                Progress.Say(string.Format(CultureInfo.InvariantCulture,
                    "The times of {0} runs spread by more than {1:0} % (column time_spread): " +
                    "something else used the device, or the flow changed. Errors do not depend on that.", busy,
                    100.0 * StepTimes.BusySpread));
            }
        }

        /// <summary>All files of a chart; cases that an earlier chart in the folder measured are drawn too.</summary>
        internal static IEnumerable<ResultFile> Files(IEnumerable<ValidationCase> selected)
        {
            var tables = new[] { ChartRow.Format.File, StepCostRow.Format.File, StepFitRow.Format.File, ErrorFitRow.Format.File,
                ParetoFront.Format.File, EqualCost.Format.File, ChartReport.File };
            return tables.Concat(ChartScript.Files()).Concat(CaseCatalogue.All.Union(selected)
                .SelectMany(c => CurveScript.Files(c).Concat(CaseMethod.All.Select(m => CurveFile.Of(c.Name, m.Name)))));
        }

        private static ChartPlan PlanFor(ChartArguments arguments)
        {
            bool software = FluidSupport.IsSoftwareDevice;
            IReadOnlyList<StepCostPoint> stepCosts = StepCostPoint.Of(arguments.Methods, arguments.Quick, software);
            if (arguments.Quick) return ChartPlan.Quick(arguments.Cases, arguments.Methods, stepCosts: stepCosts);
            return ChartPlan.Full(arguments.Cases, arguments.Methods, ChartPlan.FullBudget(software),
                software ? ChartPlan.SoftwareRunLimit : double.PositiveInfinity, stepCosts);
        }

        private SessionJob Job(StepCostPoint point)
        {
            // About a second each, or a dozen steps where these take longer, beside the start.
            double cost = 12.0 * StepWork.Of(point.Method, point.Particles, point.SupportRatio) + 1.5 * StepWork.SoftwareRate;
            StepCostRow row = null;
            return new SessionJob(point.ToString(), cost, () => costs.Contains(point.Key), () => Measure(point, r => row = r),
                () => Progress.Say(
                string.Format(CultureInfo.InvariantCulture, "{0}/{1}  {2}: {3:G3} ms{4}", Done, Count, point, row.Milliseconds,
                    TimeLeft(", "))), "step",
                key: ShardedTable.RunKey(StepCostRow.Format, point.Key));
        }

        private IEnumerator Measure(StepCostPoint point, Action<StepCostRow> done)
        {
            StepCostRow row = null;
            yield return new StepCostRun(shaders).Run(point, r => row = r);
            costs.Add(row);
            done(row);
        }

        private SessionJob Job(ChartRun run)
        {
            CaseResult result = null;
            return new SessionJob(run.ToString(), run.Cost, () => IsDone(run), () => Measure(run, r => result = r),
                () => SayResult(run, result),
                key: ShardedTable.RunKey(ChartRow.Format, run.Key));
        }

        // A run of another number of particles, as an older version had them, is done again.
        private bool IsDone(ChartRun run) => table.Contains(run.Key) &&
            table.Rows.Any(r => r.Key == run.Key && r.Particles == run.Config.Particles);

        private IEnumerator Measure(ChartRun run, Action<CaseResult> done)
        {
            CaseResult result = null;
            yield return runner(run, r => result = r);
            table.Add(ChartRow.Of(run, result));
            (string caseName, string method) = (run.Config.Case.Name, run.Config.Method.Name);
            bool best = run.Config.Factor == ChartFactor.Base || !File.Exists(CurveFile.PathOf(Folder, caseName, method));
            if (run.Seed == 1 && best && result.Series.Count > 0)
            {
                CurveFile.Write(Folder, caseName, method, run.Config.Constants, result.Series);
            }
            done(result);
        }

        private void SayResult(ChartRun run, CaseResult result)
        {
            ChartRow row = ChartRow.Of(run, result)[0];
            string outcome = row.Failed ? "failed: " + row.Reason
                : string.Format(CultureInfo.InvariantCulture, "{0} {1:G3}", row.ErrorName, row.Error);
            Progress.Say(string.Format(CultureInfo.InvariantCulture, "{0}/{1}  {2}: {3}, {4:N0} GPU ms/s{5}", Done, Count, run, outcome,
                row.GpuMsPerSecond, TimeLeft(", ")));
        }
    }
}
