using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>A curve through points with ascending abscissas, straight between them.</summary>
    internal sealed class SampledCurve
    {
        private readonly List<double> xs = new List<double>();
        private readonly List<double> ys = new List<double>();

        public int Count => xs.Count;

        public IReadOnlyList<(double X, double Y)> Points => xs.Select((x, i) => (x, ys[i])).ToArray();

        public double LastX => xs.Count == 0 ? double.NaN : xs[xs.Count - 1];

        public void Add(double x, double y)
        {
            xs.Add(x);
            ys.Add(y);
        }

        /// <summary>The ordinate at an abscissa; not a number beyond the ends.</summary>
        public double At(double x)
        {
            if (xs.Count == 0 || !(x >= xs[0]) || x > LastX) return double.NaN;
            int above = xs.BinarySearch(x);
            if (above >= 0) return ys[above];
            above = ~above;
            double part = (x - xs[above - 1]) / (xs[above] - xs[above - 1]);
            return ys[above - 1] + part * (ys[above] - ys[above - 1]);
        }

        /// <summary>The points with their abscissas times a scale and then moved.</summary>
        public CaseSeries ToSeries(string name, double scale, double shift)
        {
            var series = new CaseSeries(name);
            for (int i = 0; i < xs.Count; i++) series.Add(xs[i] * scale + shift, ys[i]);
            return series;
        }
    }
}
