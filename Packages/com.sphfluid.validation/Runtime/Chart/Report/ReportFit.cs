using System.Collections.Generic;

namespace SphFluid.Validation
{
    /// <summary>A curve in a panel of the report: what a model makes of a method's points.</summary>
    internal sealed class ReportFit
    {
        /// <param name="method">Name of the method.</param>
        /// <param name="title">What the curve is, for tooltips.</param>
        /// <param name="points">GPU ms per simulated second and error, in the order in which they are joined.</param>
        public ReportFit(string method, string title, IReadOnlyList<(double Cost, double Error)> points)
        {
            Method = method;
            Title = title;
            Points = points;
        }

        /// <summary>Name of the method.</summary>
        public string Method { get; }

        /// <summary>What the curve is.</summary>
        public string Title { get; }

        /// <summary>GPU ms per simulated second and error.</summary>
        public IReadOnlyList<(double Cost, double Error)> Points { get; }
    }
}
