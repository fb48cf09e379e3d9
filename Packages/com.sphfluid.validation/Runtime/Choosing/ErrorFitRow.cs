using System;
using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>A line of error-fits.csv: how the error of a case falls with the spacing, for one method, κ and speed of sound.</summary>
    public sealed class ErrorFitRow
    {
        /// <summary>The file.</summary>
        public static readonly TableFormat<ErrorFitRow> Format = new TableFormat<ErrorFitRow>("error-fits.csv")
            .Text("case", r => r.model.Case.Name)
            .Text("error_name", r => r.model.Case.ErrorName)
            .Text("method", r => r.curve.First.Method)
            .Number("kappa", r => r.curve.First.SupportRatio)
            .Number("c_or_iterations", r => r.curve.First.SoundSpeedRatio)
            .Count("points", r => r.curve.Error.Measured.Count)
            .Count("coarsest", r => (long)Math.Round(r.curve.Error.Measured.First))
            .Count("finest", r => (long)Math.Round(r.curve.Error.Measured.Last))
            .Number("error_coarsest", r => Math.Exp(r.curve.Error.Measured.At(r.curve.Error.Measured.First)))
            .Number("error_finest", r => Math.Exp(r.curve.Error.Measured.At(r.curve.Error.Measured.Last)))
            .Number("order", r => r.Order)
            .Number("order_error", r => r.OrderError)
            .Number("seed_scatter", r => r.curve.Error.Scatter)
            .Number("wander", r => r.curve.Error.Wander);

        private readonly ErrorModel model;
        private readonly ChoiceCurve curve;

        private ErrorFitRow(ErrorModel model, ChoiceCurve curve)
        {
            this.model = model;
            this.curve = curve;
            (Order, OrderError) = curve.Error.Measured.Slope();
            Order = -Order;
        }

        /// <summary>
        /// p of an error that falls as dxᵖ: the slope of a straight line through all points on logarithmic axes; not a number with one
        /// point.
        /// </summary>
        public double Order { get; }

        /// <summary>Standard error of the order; not a number with fewer than three points.</summary>
        public double OrderError { get; }

        /// <summary>The lines of a chart.</summary>
        internal static IEnumerable<ErrorFitRow> Of(ChartData chart, IEnumerable<ValidationCase> cases) =>
            from model in ErrorModel.Of(chart, cases) from curve in model.Curves select new ErrorFitRow(model, curve);
    }
}
