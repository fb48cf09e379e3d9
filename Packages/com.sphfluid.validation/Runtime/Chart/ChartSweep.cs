using System;
using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>The points of a case and method that a chart may have, the most telling first, each with its seeds.</summary>
    internal static class ChartSweep
    {
        /// <summary>Seeds of every point that a fit takes in; the base has two more.</summary>
        public const int Seeds = 3, BaseSeeds = 5;

        private static readonly double[] coarse = { 0.5, 0.67 }, fine = { 1.5, 2.0 };
        private static readonly double[] offeredSupports = { 2.0, 2.25, 2.5 }, otherSupports = { 1.75, 3.0 };
        private static readonly double[] timeSteps = { 0.25, 0.5, 0.75 };
        private static readonly double[] wholeBase = { 1.0 };

        /// <summary>
        /// All points. The spacing is swept at the base, and for methods that users choose also at each support among which they choose and
        /// at half the speed of sound, so that each of these has a curve of its own; time step and other values are swept about the base
        /// alone.
        /// </summary>
        public static IEnumerable<ChartRun> Full(ValidationCase validationCase, CaseMethod method)
        {
            CaseParameters start = validationCase.Base(method);
            var basis = new List<ChartConfig> { new ChartConfig(validationCase, start, ChartFactor.Base) };
            List<ChartConfig> coarser = Spacings(validationCase, start, coarse).ToList();
            // The spacings' curve comes first, with its seeds: without it nothing else can be placed.
            IEnumerable<ChartRun> curve = Seeded(basis.Concat(coarser), 1, 1).Concat(Seeded(coarser.Concat(basis), 2, Seeds));
            if (method.IsReference) return curve;
            var fitted = new List<ChartConfig>();
            if (IsOffered(method))
            {
                fitted.AddRange(Supports(validationCase, start, method, coarse).Concat(SoundSpeeds(validationCase, start, 0.5, coarse)));
            }
            fitted.AddRange(Supports(validationCase, start, method, wholeBase));
            fitted.AddRange(Spacings(validationCase, start, fine[0]));
            fitted.AddRange(SoundSpeeds(validationCase, start, 0.5, wholeBase));
            IEnumerable<ChartConfig> others = Spacings(validationCase, start, fine[1])
                .Concat(SoundSpeeds(validationCase, start, 2.0, wholeBase))
                .Concat(
                    timeSteps
                        .SelectMany(t => At(validationCase, start, ChartFactor.TimeStep, 1.0,
                            (ref CaseParameters p) => p.TimeStepFraction = t)))
                .Concat(
                    otherSupports
                        .SelectMany(k => At(validationCase, start, ChartFactor.Support, 1.0,
                            (ref CaseParameters p) => p.SupportRatio = k)));
            return curve.Concat(Seeded(fitted, 1, Seeds)).Concat(Seeded(others, 1, Seeds)).Concat(Seeded(basis, Seeds + 1, BaseSeeds));
        }

        /// <summary>
        /// The points of a short chart. Spacings and supports are compared about the base, or about the finest coarser spacing at which
        /// they take no more than the share; the base itself then comes after them.
        /// </summary>
        public static IEnumerable<ChartRun> Quick(ValidationCase validationCase, CaseMethod method, double share)
        {
            CaseParameters start = validationCase.Base(method);
            var basis = new ChartConfig(validationCase, start, ChartFactor.Base);
            List<ChartConfig> first = null, coarser = null;
            foreach (double scale in new[] { 1.0, coarse[1], coarse[0] })
            {
                coarser = Spacings(validationCase, start, coarse.Where(c => c < scale).Reverse().ToArray()).ToList();
                first = (scale < 1.0 ? Spacings(validationCase, start, scale) : new[] { basis }).Concat(coarser)
                    .Concat(method.IsReference ? Enumerable.Empty<ChartConfig>() : Supports(validationCase, start, method, scale))
                    .ToList();
                if (Seeded(first, 1, 1).Sum(r => r.Cost) <= share) break;
            }
            IEnumerable<ChartRun> runs = Seeded(first, 1, 1);
            if (method.IsReference) return runs;
            IEnumerable<ChartConfig> others = SoundSpeeds(validationCase, start, 0.5, wholeBase)
                .Concat(At(validationCase, start, ChartFactor.TimeStep, 1.0,
                    (ref CaseParameters p) => p.TimeStepFraction = start.TimeStepFraction > 0.5 ? 0.5 : 0.75));
            return runs.Concat(Seeded(coarser, 2, Seeds)).Concat(Seeded(new[] { basis }, 1, 1)).Concat(Seeded(others, 1, 1))
                .Concat(Seeded(new[] { basis }, 2, Seeds));
        }

        /// <summary>Part of a chart's time that a method gets beside others'.</summary>
        public static double Weight(CaseMethod method) => method.IsReference ? 0.3 : IsOffered(method) ? 1.0 : 0.7;

        /// <summary>Whether users choose the method for their liquids: not the thesis's, which is there to be compared with.</summary>
        public static bool IsOffered(CaseMethod method) => method.Kind != FluidMethodKind.Thesis && !method.IsReference;

        private delegate void Change(ref CaseParameters parameters);

        private static IEnumerable<ChartConfig> Spacings(ValidationCase validationCase, CaseParameters start, params double[] scales) =>
            scales.SelectMany(s => At(validationCase, start, ChartFactor.Spacing, s, (ref CaseParameters p) => { }));

        private static IEnumerable<ChartConfig> Supports(ValidationCase validationCase, CaseParameters start, CaseMethod method,
            params double[] scales) =>
                from scale in scales
                from support in IsOffered(method) ? offeredSupports : new[] { 2.5 }
                from point in At(validationCase, start, ChartFactor.Support, scale, (ref CaseParameters p) => p.SupportRatio = support)
                where !point.SupportRatio.Equals(start.SupportRatio)
                select point;

        private static IEnumerable<ChartConfig> SoundSpeeds(ValidationCase validationCase, CaseParameters start, double ratio,
            params double[] scales) =>
                scales
                    .SelectMany(s => At(validationCase, start, ChartFactor.SoundSpeed, s,
                        (ref CaseParameters p) => p.SoundSpeedRatio *= ratio));

        // Nothing where the point is the base itself.
        private static IEnumerable<ChartConfig> At(ValidationCase validationCase, CaseParameters start, ChartFactor factor, double scale,
            Change change)
        {
            CaseParameters point = start;
            point.Resolution = (int)Math.Round(start.Resolution * scale);
            bool scaled = point.Resolution != start.Resolution;
            change(ref point);
            bool same = !scaled && point.SupportRatio.Equals(start.SupportRatio) && point.TimeStepFraction.Equals(start.TimeStepFraction) &&
                point.SoundSpeedRatio.Equals(start.SoundSpeedRatio);
            if (!same && point.Resolution > 0)
            {
                yield return new ChartConfig(validationCase, point, scaled && factor != ChartFactor.Spacing ? ChartFactor.Several : factor);
            }
        }

        private static IEnumerable<ChartRun> Seeded(IEnumerable<ChartConfig> configs, int first, int last)
        {
            List<ChartConfig> list = configs.ToList();
            for (int seed = first; seed <= last; seed++)
            {
                foreach (ChartConfig config in list) yield return new ChartRun(config, seed);
            }
        }
    }
}
