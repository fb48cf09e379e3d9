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

        readonly ChartArguments arguments;
        readonly Runner runner;
        readonly ChartTable table;
        readonly ChartPlan plan;

        /// <summary>Prepares a chart; nothing is measured yet.</summary>
        /// <param name="arguments">What to measure.</param>
        /// <param name="shaders">The package's shaders.</param>
        /// <param name="progress">Where it says how far it is.</param>
        /// <exception cref="CommandLineException">The folder has a chart that cannot be gone on with.</exception>
        /// <exception cref="FluidDeviceException">The device has no GPU times.</exception>
        public ChartSession(ChartArguments arguments, FluidShaderSet shaders, SessionProgress progress)
            : this(arguments, PlanFor(arguments), new ChartRunner(shaders).Run, progress, SystemInfo.graphicsDeviceName,
                new SessionRate(SurfaceGridSizes.IsSoftwareDevice ? ChartPlan.SoftwareRate : (double?)null))
        {
        }

        internal ChartSession(ChartArguments arguments, ChartPlan plan, Runner runner, SessionProgress progress, string device, SessionRate rate)
            : base(arguments, "runs", device, progress, rate)
        {
            this.arguments = arguments;
            this.plan = plan;
            this.runner = runner;
            table = ChartTable.Load(arguments.OutputFolder, device);
            Claim(Files(arguments.Cases));
        }

        private protected override IEnumerable<SessionJob> Jobs()
        {
            foreach (ChartConfig config in plan.Unbuildable)
                Progress.Say($"Not part of the chart: {config}: {config.Problem}");
            if (plan.LeftOut.Count > 0)
                Progress.Say($"{plan.LeftOut.Count} runs are left out, {(arguments.Quick ? "they do not fit into the short plan's time" : "they take too long on this device")}: {plan.DescribeLeftOut()}.");
            return plan.Runs.Select(Job);
        }

        private protected override void Draw() => new ChartDrawing(arguments.OutputFolder, table, arguments.Cases, Progress).Write();

        // Cases that an earlier chart in the folder measured are drawn too.
        static IEnumerable<ResultFile> Files(IEnumerable<ValidationCase> selected)
        {
            yield return ResultFile.Table(ChartTable.FileName, ChartRow.Columns);
            yield return ResultFile.Table(ParetoFront.FileName, ParetoFront.Columns);
            yield return ResultFile.Table(EqualCost.FileName, EqualCost.Columns);
            yield return ResultFile.Text(ChartScript.FileName, ChartScript.FirstLine);
            yield return ResultFile.Drawn("accuracy.svg", ChartScript.FileName);
            yield return ResultFile.Drawn("accuracy.png", ChartScript.FileName);
            foreach (ValidationCase validationCase in ValidationCases.All.Union(selected))
            {
                string script = CurveScript.NameOf(validationCase);
                yield return ResultFile.Text(script, CurveScript.FirstLineOf(validationCase));
                yield return ResultFile.Drawn(CurveScript.PictureOf(validationCase), script);
                foreach (CaseMethod method in CaseMethod.All)
                    yield return ResultFile.Table(CurveFile.NameOf(validationCase.Name, method.Name), CurveFile.Columns);
            }
        }

        static ChartPlan PlanFor(ChartArguments arguments)
        {
            if (arguments.Quick)
                return ChartPlan.Quick(arguments.Cases, arguments.Methods);
            return ChartPlan.Full(arguments.Cases, arguments.Methods,
                SurfaceGridSizes.IsSoftwareDevice ? ChartPlan.SoftwareRunLimit : double.PositiveInfinity);
        }

        SessionJob Job(ChartRun run)
        {
            CaseResult result = null;
            return new SessionJob(run.ToString(), run.Cost, () => table.Contains(run), () => Measure(run, r => result = r), () => SayResult(run, result));
        }

        IEnumerator Measure(ChartRun run, Action<CaseResult> done)
        {
            CaseResult result = null;
            yield return runner(run, r => result = r);
            table.Add(run, result, DateTime.UtcNow.ToString("yyyy-MM-dd", CultureInfo.InvariantCulture));
            table.Write(arguments.OutputFolder);
            string file = CurveFile.PathOf(arguments.OutputFolder, run.Config.Case.Name, run.Config.Method.Name);
            bool best = run.Config.Factor == ChartFactor.Base || !File.Exists(file);
            if (run.Seed == 1 && best && result.Series.Count > 0)
                CurveFile.Write(file, run.Config.Constants, result.Series);
            done(result);
        }

        void SayResult(ChartRun run, CaseResult result)
        {
            ChartRow row = ChartRow.Of(run, result, table.Device, "")[0];
            string outcome = row.Failed ? "failed: " + row.Reason : string.Format(CultureInfo.InvariantCulture, "{0} {1:G3}", row.ErrorName, row.Error);
            Progress.Say(string.Format(CultureInfo.InvariantCulture, "{0}/{1}  {2}: {3}, {4:N0} GPU ms/s{5}", Done, Count, run, outcome,
                row.GpuMsPerSecond, TimeLeft(", ")));
        }
    }
}
