using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>What a chart says of one case: curves of error and time for each method, κ and speed of sound that it measured.</summary>
    internal sealed class ErrorModel
    {
        /// <summary>
        /// Before anything is measured: seeds differ by 5 %, and between spacings a factor e apart an error wanders by a factor two.
        /// </summary>
        public static readonly CurveSpread Expected = CurveSpread.Expected(0.05, 0.7);

        private ErrorModel(ValidationCase validationCase, IReadOnlyList<ChoiceCurve> curves)
        {
            Case = validationCase;
            Curves = curves;
        }

        /// <summary>The case.</summary>
        public ValidationCase Case { get; }

        /// <summary>Its curves.</summary>
        public IReadOnlyList<ChoiceCurve> Curves { get; }

        /// <summary>
        /// The models of all cases that a chart measured, each case's curves learning from each other and from those of other cases.
        /// </summary>
        /// <param name="chart">The chart.</param>
        /// <param name="cases">The cases.</param>
        public static IReadOnlyList<ErrorModel> Of(ChartData chart, IEnumerable<ValidationCase> cases)
        {
            List<ErrorModel> models = cases.Select(c => new ErrorModel(c, ChoiceCurve.Of(chart, c)))
                .Where(m => m.Curves.Count > 0).ToList();
            CurveSpread all = CurveSpread.Of(models.SelectMany(m => m.Curves).Select(c => c.Error.Measured).ToList(), Expected);
            CurveSpread times =
                CurveSpread.Of(models.SelectMany(m => m.Curves).Select(c => c.TimeRatio).ToList(), ChoiceCurve.ExpectedTime);
            foreach (ErrorModel model in models)
            {
                CurveSpread own = CurveSpread.Of(model.Curves.Select(c => c.Error.Measured).ToList(), all);
                CurveSpread ownTimes = CurveSpread.Of(model.Curves.Select(c => c.TimeRatio).ToList(), times);
                foreach (ChoiceCurve curve in model.Curves) curve.Learn(own, ownTimes);
            }
            return models;
        }
    }
}
