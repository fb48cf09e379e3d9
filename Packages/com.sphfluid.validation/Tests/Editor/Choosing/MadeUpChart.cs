using System;
using System.Collections.Generic;
using System.Linq;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    /// <summary>A chart of a cube's rest whose errors and times follow known laws.</summary>
    internal sealed class MadeUpChart
    {
        public const string Device = "a device";

        public readonly FlatCase Case = new FlatCase("flat", 12);
        private readonly ChartRows rows = new ChartRows(Device);

        public IReadOnlyList<ChartRow> Rows => rows.Rows;

        /// <summary>
        /// Error of a run: at κ = 2 first, at 2.5 second order; the thesis errs three times as much. Floor 0.04 as the case has.
        /// </summary>
        public static double ErrorOf(string method, double ratio, int resolution) =>
            (method == "standard" ? 1.0 : 3.0) * (ratio < 2.25 ? 3.0 / resolution : 20.0 / resolution / resolution);

        /// <summary>Time of a step [ms].</summary>
        public static double StepTimeOf(string method, double ratio, int particles) =>
            (method == "standard" ? 1.0 : 2.0) * (0.5 + 1e-3 * particles * (1.0 + 0.1 * ratio * ratio * ratio));

        /// <summary>The drift of a method over its height's error.</summary>
        public Func<string, double> DriftOver { get; set; } = _ => -0.1;

        public ChartData Data(string folder = "made up") => new ChartData(folder, Rows, StepCosts());

        public void Sweep(string method, double ratio, double soundSpeed, params int[] resolutions)
        {
            foreach (int resolution in resolutions)
            {
                for (int seed = 1; seed <= 3; seed++) Add(method, ratio, soundSpeed, resolution, seed);
            }
        }

        public void Add(string method, double ratio, double soundSpeed, int resolution, int seed, string failure = null,
            double errorFactor = 1.0)
        {
            CaseParameters parameters = Case.Base(CaseMethod.Find(method));
            (parameters.SupportRatio, parameters.SoundSpeedRatio, parameters.Resolution) = (ratio, soundSpeed, resolution);
            var run = new ChartRun(new ChartConfig(Case, parameters, ChartFactor.Several), seed);
            double step = StepTimeOf(method, ratio, run.Config.Particles) * (1.0 + 0.01 * (seed - 2));
            CaseResult result = FlatCase.Result(step / run.Config.TimeStep,
                errorFactor * ErrorOf(method, ratio, resolution) * (1.0 + 0.02 * (seed - 2)), failure, DriftOver(method));
            result.TimeStep = run.Config.TimeStep;
            rows.Add(run, result, "2026-11-25");
        }

        private static List<StepCostRow> StepCosts() =>
            (from method in new[] { "standard", "standard-corrected", "thesis" }
             from ratio in new[] { 2.0, 2.5 }
             from count in new[] { 500, 1000, 2000, 4000, 16000 }
             select StepCostRow.Of(new StepCostPoint(CaseMethod.Find(method), ratio, count), 10,
                 StepTimes.Of(new[] { 10.0 * StepTimeOf(method, ratio, count) }, new[] { 10 }))).ToList();
    }
}
