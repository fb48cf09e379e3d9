using System;
using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>What the seeds of one point gave for one error: medians, least and greatest.</summary>
    public sealed class ChartPoint
    {
        private readonly ChartRow first;

        private ChartPoint(ChartRow first)
        {
            this.first = first;
        }

        /// <summary>Name of the case.</summary>
        public string Case => first.Case;

        /// <summary>Name of the method.</summary>
        public string Method => first.Method;

        /// <summary>Particle spacing dx [m].</summary>
        public double Spacing => first.Spacing;

        /// <summary>κ = R/dx.</summary>
        public double SupportRatio => first.SupportRatio;

        /// <summary>Time step over the method's stable one.</summary>
        public double TimeStepFraction => first.TimeStepFraction;

        /// <summary>Speed of sound over the case's own speed.</summary>
        public double SoundSpeedRatio => first.SoundSpeedRatio;

        /// <summary>Number of particles.</summary>
        public int Particles => first.Particles;

        /// <summary>The graphics device.</summary>
        public string Device => first.Device;

        /// <summary>Day of the first run, e.g. 2026-11-21.</summary>
        public string Date => first.Date;

        /// <summary>The name of the point: see <see cref="ChartConfig.Key"/>.</summary>
        public string Key => first.Point;

        /// <summary>Name of the error.</summary>
        public string ErrorName { get; private set; }

        /// <summary>Number of runs.</summary>
        public int Seeds { get; private set; }

        /// <summary>Number of runs that failed.</summary>
        public int Failures { get; private set; }

        /// <summary>Why the first of them failed; empty when none did.</summary>
        public string Reason { get; private set; } = "";

        /// <summary>
        /// GPU time per simulated second of the runs that did not fail, or of all when all did [ms/s]; null when it was not measured.
        /// </summary>
        public SampleStatistics? Cost { get; private set; }

        /// <summary>Magnitude of the error of the runs that did not fail; null when all did.</summary>
        public SampleStatistics? Error { get; private set; }

        /// <summary>Whether every run has an error and a time: only such points compare.</summary>
        public bool IsWhole => Failures == 0 && Cost.HasValue && Error.HasValue;

        /// <summary>The points of an error in the order of their first runs.</summary>
        /// <param name="rows">Lines of the table.</param>
        /// <param name="caseName">Name of the case.</param>
        /// <param name="errorName">Name of the error; of a run that failed any line counts.</param>
        public static IReadOnlyList<ChartPoint> Of(IEnumerable<ChartRow> rows, string caseName, string errorName)
        {
            var points = new List<ChartPoint>();
            foreach (IGrouping<string, ChartRow> group in rows.Where(r => r.Case == caseName).GroupBy(r => r.Point))
            {
                List<ChartRow> runs = group.GroupBy(r => r.Seed)
                    .Select(seed => seed.FirstOrDefault(r => r.ErrorName == errorName) ?? seed.First()).ToList();
                List<ChartRow> passed = runs.Where(r => !r.Failed).ToList();
                points.Add(new ChartPoint(runs[0])
                {
                    ErrorName = errorName,
                    Seeds = runs.Count,
                    Failures = runs.Count - passed.Count,
                    Reason = runs.FirstOrDefault(r => r.Failed)?.Reason ?? "",
                    Cost = Statistics((passed.Count > 0 ? passed : runs).Select(r => r.GpuMsPerSecond)),
                    Error = Statistics(passed.Where(r => r.ErrorName == errorName).Select(r => Math.Abs(r.Error))),
                });
            }
            return points;
        }

        /// <summary>What the point differs in from a base.</summary>
        public ChartFactor FactorFrom(ChartConfig start)
        {
            ChartFactor factor = ChartFactor.Base;
            Compare(Spacing, start.Spacing, ChartFactor.Spacing, ref factor);
            Compare(SupportRatio, start.SupportRatio, ChartFactor.Support, ref factor);
            Compare(TimeStepFraction, start.TimeStepFraction, ChartFactor.TimeStep, ref factor);
            Compare(SoundSpeedRatio, start.SoundSpeedRatio, ChartFactor.SoundSpeed, ref factor);
            return factor;
        }

        // As written in the file.
        private static void Compare(double value, double start, ChartFactor which, ref ChartFactor factor)
        {
            if (CsvText.Text(value) != CsvText.Text(start)) factor = factor == ChartFactor.Base ? which : ChartFactor.Several;
        }

        private static SampleStatistics? Statistics(IEnumerable<double> values)
        {
            List<double> finite = values.Where(v => !double.IsNaN(v) && !double.IsInfinity(v)).ToList();
            return finite.Count == 0 ? (SampleStatistics?)null : SampleStatistics.Of(finite);
        }
    }
}
