using System;
using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>
    /// Error and time of a case with one method, κ and speed of sound, against the number of particles along the case's length.
    /// </summary>
    internal sealed class ChoiceCurve
    {
        /// <summary>
        /// Before anything is measured: repeated times differ by 5 %, and a case's step over the fitted one wanders by a tenth.
        /// </summary>
        public static readonly CurveSpread ExpectedTime = CurveSpread.Expected(0.05, 0.1);

        private readonly LogCurve particles, steps;
        private readonly StepCostModel cost;
        private CurveSpread timeSpread = ExpectedTime;

        private ChoiceCurve(ValidationCase validationCase, IReadOnlyList<ChoicePoint> points, StepCostModel cost)
        {
            this.cost = cost;
            Points = points;
            First = points[0].First;
            double ratio = points[0].ConfigOf(validationCase).EffectiveSoundSpeedRatio;
            Compression = 1.0 / (ratio * ratio);
            List<ChoicePoint> whole = points.Where(p => !p.Failed && p.Errors.Count > 0).ToList();
            Error = new ErrorCurve(whole.Select(p => ((double)p.Resolution, p.Errors)).ToList(),
                points.Where(p => p.Failed).Select(p => (double)p.Resolution).ToList(), validationCase.Floor);
            particles = LogCurve.Of(whole.Select(p => ((double)p.Resolution, One(p.First.Particles))));
            steps = LogCurve.Of(whole.Where(p => p.TimeStep > 0.0).Select(p => ((double)p.Resolution, One(1.0 / p.TimeStep))));
            TimeRatio = LogCurve.Of(whole.Where(p => p.StepMilliseconds.Count > 0).Select(p => ((double)p.First.Particles,
                (IReadOnlyList<double>)p.StepMilliseconds.Select(t => t / cost.At(p.First.Particles, First.SupportRatio)).ToList())));
        }

        /// <summary>A run of it: case, method and constants.</summary>
        public ChartRow First { get; }

        /// <summary>Compression by motion, (v/c)², with the speed of sound that the liquid has in its steps.</summary>
        public double Compression { get; }

        /// <summary>What was measured, the coarsest first.</summary>
        public IReadOnlyList<ChoicePoint> Points { get; }

        /// <summary>The error.</summary>
        public ErrorCurve Error { get; }

        /// <summary>Measured time of a step over the fitted one, against the number of particles.</summary>
        public LogCurve TimeRatio { get; }

        /// <summary>Whether error and time are known.</summary>
        public bool IsKnown => !Error.Measured.IsEmpty && !TimeRatio.IsEmpty && !steps.IsEmpty;

        /// <summary>The curves of a case.</summary>
        public static IReadOnlyList<ChoiceCurve> Of(ChartData chart, ValidationCase validationCase)
        {
            var curves = new List<ChoiceCurve>();
            foreach (var group in ChoicePoint.Of(chart.Rows, validationCase)
                .GroupBy(p => (p.First.Method, p.First.SupportRatio, p.First.TimeStepFraction, p.First.SoundSpeedRatio)))
            {
                CaseMethod method = CaseMethod.Find(group.Key.Method);
                if (!group.Key.TimeStepFraction.Equals(validationCase.Base(method).TimeStepFraction) ||
                    !(chart.CostOf(method) is StepCostModel cost))
                {
                    continue;
                }
                var curve = new ChoiceCurve(validationCase, group.OrderBy(p => p.Resolution).ToList(), cost);
                if (curve.IsKnown) curves.Add(curve);
            }
            return curves;
        }

        /// <summary>
        /// How far each of the case's <see cref="ValidationCase.AlsoHeld"/> is from what is right: the worse of the two measured spacings
        /// beside a resolution. Not a number where one was not measured.
        /// </summary>
        public IReadOnlyList<double> BesideAt(int resolution)
        {
            List<ChoicePoint> whole = Points.Where(p => !p.Failed).ToList();
            ChoicePoint coarser = whole.LastOrDefault(p => p.Resolution <= resolution) ?? whole[0];
            ChoicePoint finer = whole.FirstOrDefault(p => p.Resolution >= resolution) ?? coarser;
            return coarser.Beside.Zip(finer.Beside, Math.Max).ToList();
        }

        /// <summary>Takes over what the case's curves show together.</summary>
        public void Learn(in CurveSpread error, in CurveSpread time)
        {
            Error.Learn(error);
            timeSpread = time;
        }

        /// <summary>Number of particles of the case at a resolution.</summary>
        public double ParticlesAt(double resolution) => Math.Exp(particles.At(resolution) + Beyond(particles, resolution));

        /// <summary>Steps of a second of the case at a resolution.</summary>
        public double StepsPerSecond(double resolution) => Math.Exp(steps.At(resolution));

        /// <summary>GPU time of a step of a liquid that flows like the case [ms].</summary>
        /// <param name="count">Its number of particles.</param>
        public Estimate StepTime(double count)
        {
            double variance = TimeRatio.VarianceAt(count, timeSpread);
            // Beyond the case's own sizes the fit is all there is.
            bool beyond = count < 0.99 * TimeRatio.First || count > 1.01 * TimeRatio.Last;
            variance += beyond ? cost.Deviation * cost.Deviation : 0.0;
            return Estimate.OfLogarithm(TimeRatio.At(count), Math.Sqrt(variance)).Times(cost.At(count, First.SupportRatio));
        }

        /// <summary>Whether a number of particles is beyond every measured one by more than twice.</summary>
        public bool IsBeyondMeasured(double count) => count > 2.0 * Math.Max(TimeRatio.Last, cost.MostParticles);

        // The number of particles grows with the cube beyond the points; within them it lies between.
        private static double Beyond(LogCurve curve, double x) => x > curve.Last ? 3.0 * Math.Log(x / curve.Last) : x < curve.First
            ? 3.0 * Math.Log(x / curve.First) : 0.0;

        private static IReadOnlyList<double> One(double value) => new[] { value };
    }
}
