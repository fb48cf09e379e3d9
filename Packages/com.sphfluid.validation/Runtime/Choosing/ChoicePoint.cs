using System;
using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>What a chart measured at one point of a case: the errors and times of its seeds.</summary>
    internal sealed class ChoicePoint
    {
        private ChoicePoint(ChartRow first, int resolution, double timeStep, IReadOnlyList<ChartRow> runs, IReadOnlyList<double> beside)
        {
            Beside = beside;
            Seeds = runs.Select(r => r.Seed).ToList();
            First = first;
            Resolution = resolution;
            TimeStep = timeStep;
            Failed = runs.Any(r => r.Failed);
            Errors = runs.Where(r => !r.Failed).Select(r => Math.Abs(r.Error)).ToList();
            StepMilliseconds = runs.Where(r => !r.Failed && r.GpuMsPerSecond > 0.0).Select(r => r.GpuMsPerSecond * timeStep).ToList();
        }

        /// <summary>The first run: case, method and constants.</summary>
        public ChartRow First { get; }

        /// <summary>Particles along the case's length.</summary>
        public int Resolution { get; }

        /// <summary>Length of a step [s].</summary>
        public double TimeStep { get; }

        /// <summary>Whether a run failed.</summary>
        public bool Failed { get; }

        /// <summary>Magnitude of the error of each seed.</summary>
        public IReadOnlyList<double> Errors { get; }

        /// <summary>GPU time of a step of each seed [ms].</summary>
        public IReadOnlyList<double> StepMilliseconds { get; }

        /// <summary>Its seeds.</summary>
        public IReadOnlyList<int> Seeds { get; }

        /// <summary>
        /// How far each of the case's <see cref="ValidationCase.AlsoHeld"/> is from what is right, in the worst seed; not a number where
        /// one was not measured.
        /// </summary>
        public IReadOnlyList<double> Beside { get; }

        /// <summary>The case with these constants.</summary>
        public ChartConfig ConfigOf(ValidationCase validationCase) => ConfigOf(validationCase, First, Resolution);

        /// <summary>The points of a case's main error.</summary>
        /// <param name="rows">Lines of accuracy.csv.</param>
        /// <param name="validationCase">The case.</param>
        public static IReadOnlyList<ChoicePoint> Of(IEnumerable<ChartRow> rows, ValidationCase validationCase)
        {
            var points = new List<ChoicePoint>();
            double length = LengthOf(validationCase);
            foreach (IGrouping<string, ChartRow> group in rows.Where(r => r.Case == validationCase.Name &&
                CaseMethod.All.Any(m => m.Name == r.Method)).GroupBy(r => r.Point))
            {
                List<ChartRow> runs = group.GroupBy(r => r.Seed)
                    .Select(seed => seed.FirstOrDefault(r => r.ErrorName == validationCase.ErrorName || r.Failed))
                    .Where(r => r != null).ToList();
                if (runs.Count == 0) continue;
                int resolution = (int)Math.Round(length / runs[0].Spacing);
                double timeStep = double.IsNaN(runs[0].TimeStep) ? TimeStepOf(validationCase, runs[0], resolution) : runs[0].TimeStep;
                points.Add(new ChoicePoint(runs[0], resolution, timeStep, runs,
                    validationCase.AlsoHeld.Select(held => Farthest(group, held.Name, held.Right)).ToList()));
            }
            return points;
        }

        private static double Farthest(IEnumerable<ChartRow> rows, string error, double right) =>
            rows.Where(r => r.ErrorName == error && !r.Failed).Select(r => Math.Abs(r.Error - right)).DefaultIfEmpty(double.NaN)
                .Aggregate((a, b) => a >= b ? a : b);

        // What the resolution divides [m].
        private static double LengthOf(ValidationCase validationCase)
        {
            var basis = new ChartConfig(validationCase, validationCase.Base(CaseMethod.Find("standard")), ChartFactor.Base);
            return basis.Spacing * basis.Parameters(1).Resolution;
        }

        // Tables from before the step was written; not a number where the case cannot be set up any more.
        private static double TimeStepOf(ValidationCase validationCase, ChartRow row, int resolution)
        {
            ChartConfig config = ConfigOf(validationCase, row, resolution);
            return config.Problem == null ? config.TimeStep : double.NaN;
        }

        private static ChartConfig ConfigOf(ValidationCase validationCase, ChartRow row, int resolution)
        {
            CaseParameters parameters = validationCase.Base(CaseMethod.Find(row.Method));
            (parameters.Resolution, parameters.SupportRatio) = (resolution, row.SupportRatio);
            (parameters.TimeStepFraction, parameters.SoundSpeedRatio) = (row.TimeStepFraction, row.SoundSpeedRatio);
            return new ChartConfig(validationCase, parameters, ChartFactor.Several);
        }
    }
}
