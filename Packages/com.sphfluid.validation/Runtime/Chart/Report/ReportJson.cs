using System.Collections.Generic;
using System.Globalization;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>
    /// The report's data for its script: methods, factors, and for each case its panels (points, and where there are some curves of models
    /// and marks) and curves.
    /// </summary>
    internal static class ReportJson
    {
        /// <summary>All of it. The text may stand between script tags: it has no character that HTML knows.</summary>
        public static string Of(IReadOnlyList<ReportCase> cases)
        {
            JsonObject data = new JsonObject()
                .Add("framesPerSecond", ReportWords.FramesPerSecond)
                .Add("methods", CaseMethod.All.Select(m => new JsonObject().Add("name", m.Name).Add("title", m.Title)))
                .Add("factors", ChartStyle.Factors.Select(f => new JsonObject().Add("name", f.Factor.ToString()).Add("title", f.Title)))
                .Add("cases", cases.Select(Case));
            return data.ToString().Replace("<", "\\u003c").Replace(">", "\\u003e").Replace("&", "\\u0026");
        }

        private static JsonObject Case(ReportCase reported) => new JsonObject()
            .Add("name", reported.Case.Name)
            .Add("title", reported.Case.Title)
            .Add("panels", reported.Panels.Select(Panel))
            .Add("curves", Curves(reported));

        private static JsonObject Panel(ReportPanel reported) => new JsonObject()
            .Add("error", reported.Panel.ErrorName)
            .Add("isFraction", reported.Panel.IsFraction ? 1 : 0)
            .Add("floor", reported.Panel.Case.Floor)
            .Add("points", reported.Panel.Points.Select(p => Point(reported, p)))
            .Add("fits", reported.Fits.Select(Fit))
            .Add("marks", reported.Marks.Select(Mark));

        private static JsonObject Point(ReportPanel reported, ChartPoint point) => new JsonObject()
            .Add("method", IndexOf(point.Method))
            .Add("factor", reported.Panel.FactorOf(point).ToString())
            .Add("dx", Rounded(point.Spacing))
            .Add("kappa", Rounded(point.SupportRatio))
            .Add("timeStep", Rounded(point.TimeStepFraction))
            .Add("soundSpeed", Rounded(point.SoundSpeedRatio))
            .Add("particles", point.Particles)
            .Add("seeds", point.Seeds)
            .Add("failures", point.Failures)
            .Add("reason", point.Reason)
            .Add("front", reported.IsOnFront(point) ? 1 : 0)
            .Add("cost", Bar(point.Cost))
            .Add("err", Bar(point.Error));

        private static JsonObject Fit(ReportFit fit) => new JsonObject()
            .Add("method", IndexOf(fit.Method))
            .Add("title", fit.Title)
            .Add("cost", fit.Points.Select(p => Rounded(p.Cost)))
            .Add("err", fit.Points.Select(p => Rounded(p.Error)));

        private static JsonObject Mark(ReportMark mark) =>
            new JsonObject().Add("title", mark.Title).Add("cost", Bar(mark.Cost)).Add("err", Bar(mark.Error));

        private static JsonObject Curves(ReportCase reported) => new JsonObject()
            .Add("x", reported.Case.AxisTitles.X)
            .Add("y", reported.Case.AxisTitles.Y)
            .Add("references", reported.Curves.References.Select(r => Reference(r, reported.Curves.BandOf(r))))
            .Add("runs", reported.Curves.Runs.Select(r => new JsonObject()
                .Add("method", r.Method)
                .Add("constants", r.Constants)
                .Add("curves", r.Curves.Select(Curve))));

        private static JsonObject Reference(CaseSeries curve, CaseSeries band) => Curve(curve)
            .Add("bandX", (band?.X ?? Enumerable.Empty<double>()).Select(Rounded))
            .Add("low", (band?.Y ?? Enumerable.Empty<double>()).Select(Rounded))
            .Add("high", (band?.Upper ?? Enumerable.Empty<double>()).Select(Rounded));

        private static JsonObject Curve(CaseSeries curve) => new JsonObject()
            .Add("name", curve.Name)
            .Add("x", curve.X.Select(Rounded))
            .Add("y", curve.Y.Select(Rounded));

        // Median, least and greatest; empty where there is nothing.
        private static IEnumerable<double> Bar(SampleStatistics? bar) =>
            bar.HasValue ? new[] { bar.Value.Median, bar.Value.Minimum, bar.Value.Maximum }.Select(Rounded) : Enumerable.Empty<double>();

        private static int IndexOf(string method) => CaseMethod.All.Select(m => m.Name).ToList().IndexOf(method);

        // Five digits: more than a screen shows.
        private static double Rounded(double value) => double.IsNaN(value) || double.IsInfinity(value)
            ? double.NaN
            : double.Parse(value.ToString("G5", CultureInfo.InvariantCulture), CultureInfo.InvariantCulture);
    }
}
