using System;
using System.Collections;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Linq;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// Measures a chart run by run and draws it. The table is written after every run, and runs that it holds already are not done
    /// again: an interrupted chart goes on by the same command.
    /// </summary>
    public sealed class ChartSession : IValidationSession
    {
        /// <summary>Makes the work of a run, which hands over its result.</summary>
        internal delegate IEnumerator Runner(ChartRun run, Action<CaseResult> done);

        readonly ChartArguments arguments;
        readonly Runner runner;
        readonly SessionProgress progress;
        readonly ChartTable table;
        readonly ChartPlan plan;
        readonly ChartRate rate;
        readonly SessionWork work;
        bool disposed;

        /// <summary>Prepares a chart; nothing is measured yet.</summary>
        /// <param name="arguments">What to measure.</param>
        /// <param name="shaders">The package's shaders.</param>
        /// <param name="progress">Where it says how far it is.</param>
        /// <exception cref="CommandLineException">The folder has a chart that cannot be gone on with.</exception>
        /// <exception cref="FluidDeviceException">The device has no GPU times.</exception>
        public ChartSession(ChartArguments arguments, FluidShaderSet shaders, SessionProgress progress)
            : this(arguments, PlanFor(arguments), new ChartRunner(shaders).Run, progress, SystemInfo.graphicsDeviceName,
                new ChartRate(SurfaceGridSizes.IsSoftwareDevice ? ChartPlan.SoftwareRate : (double?)null))
        {
        }

        internal ChartSession(ChartArguments arguments, ChartPlan plan, Runner runner, SessionProgress progress, string device, ChartRate rate)
        {
            this.arguments = arguments;
            this.plan = plan;
            this.runner = runner;
            this.progress = progress;
            this.rate = rate;
            table = ChartTable.Load(arguments.OutputFolder, device);
            Directory.CreateDirectory(arguments.OutputFolder);
            work = new SessionWork(Run());
        }

        /// <inheritdoc/>
        public bool Step() => work.Step();

        /// <summary>Says how to go on when it is not done; the files are whole at any time.</summary>
        public void Dispose()
        {
            if (disposed)
                return;
            disposed = true;
            if (!work.IsDone)
                progress.Say($"Stopped early. '{Path.Combine(arguments.OutputFolder, ChartTable.FileName)}' holds every finished run; the same command goes on from there.");
            work.Clear();
        }

        static ChartPlan PlanFor(ChartArguments arguments)
        {
            if (arguments.Quick)
                return ChartPlan.Quick(arguments.Cases, arguments.Methods);
            return ChartPlan.Full(arguments.Cases, arguments.Methods,
                SurfaceGridSizes.IsSoftwareDevice ? ChartPlan.SoftwareRunLimit : double.PositiveInfinity);
        }

        IEnumerator Run()
        {
            List<ChartRun> pending = plan.Runs.Where(r => !table.Contains(r)).ToList();
            SayPlan(pending.Count);
            var clock = Stopwatch.StartNew();
            double left = pending.Sum(r => r.Cost);
            for (int i = 0; i < pending.Count; i++)
            {
                ChartRun run = pending[i];
                if (i > 0 && arguments.Slice.HasValue && clock.Elapsed + (rate.TimeFor(run.Cost) ?? TimeSpan.Zero) > arguments.Slice.Value)
                {
                    Draw();
                    progress.Say($"Time is up with {plan.Runs.Count - pending.Count + i} of {plan.Runs.Count} runs done{TimeLeft(left, ", about ")}. " +
                        "The same command goes on from there.");
                    yield break;
                }
                progress.Show(1.0 - left / plan.Cost, rate.TimeFor(left), run.ToString());
                CaseResult result = null;
                var runClock = Stopwatch.StartNew();
                yield return runner(run, r => result = r);
                rate.Add(run.Cost, runClock.Elapsed);
                left -= run.Cost;
                Keep(run, result);
                SayResult(run, result, plan.Runs.Count - pending.Count + i + 1, left);
            }
            Draw();
            progress.Say($"All {plan.Runs.Count} runs are done.");
        }

        void Keep(ChartRun run, CaseResult result)
        {
            table.Add(run, result, DateTime.UtcNow.ToString("yyyy-MM-dd", CultureInfo.InvariantCulture));
            table.Write(arguments.OutputFolder);
            string file = CurveFile.PathOf(arguments.OutputFolder, run.Config.Case.Name, run.Config.Method.Name);
            bool best = run.Config.Factor == ChartFactor.Base || !File.Exists(file);
            if (run.Seed == 1 && best && result.Series.Count > 0)
                CurveFile.Write(file, run.Config.Constants, result.Series);
        }

        void Draw()
        {
            var drawing = new ChartDrawing(arguments.OutputFolder, table, arguments.Cases, progress);
            drawing.Write();
        }

        void SayPlan(int pending)
        {
            foreach (ChartConfig config in plan.Unbuildable)
                progress.Say($"Not part of the chart: {config}: {config.Problem}");
            if (plan.LeftOut.Count > 0)
                progress.Say($"{plan.LeftOut.Count} runs are left out, {(arguments.Quick ? "they do not fit into the short plan's time" : "they take too long on this device")}: {plan.DescribeLeftOut()}.");
            string done = pending < plan.Runs.Count ? $", {plan.Runs.Count - pending} of them are there already" : "";
            double work = plan.Runs.Where(r => !table.Contains(r)).Sum(r => r.Cost);
            progress.Say($"{plan.Runs.Count} runs on {table.Device}{done}{TimeLeft(work, ", about ")}.");
        }

        void SayResult(ChartRun run, CaseResult result, int done, double left)
        {
            ChartRow row = ChartRow.Of(run, result, table.Device, "")[0];
            string outcome = row.Failed ? "failed: " + row.Reason : string.Format(CultureInfo.InvariantCulture, "{0} {1:G3}", row.ErrorName, row.Error);
            progress.Say(string.Format(CultureInfo.InvariantCulture, "{0}/{1}  {2}: {3}, {4:N0} GPU ms/s{5}", done, plan.Runs.Count, run, outcome,
                row.GpuMsPerSecond, TimeLeft(left, ", ")));
        }

        string TimeLeft(double cost, string before)
        {
            TimeSpan? time = rate.TimeFor(cost);
            return time.HasValue && cost > 0.0 ? before + SessionProgress.Duration(time.Value) + " left" : "";
        }
    }
}
