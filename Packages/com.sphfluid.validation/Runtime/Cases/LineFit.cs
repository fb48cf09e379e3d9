namespace SphFluid.Validation
{
    /// <summary>The straight line of least squares through points that come one by one.</summary>
    public sealed class LineFit
    {
        private double count, meanX, meanY, squaresX, products;

        /// <summary>Number of points.</summary>
        public int Count => (int)count;

        /// <summary>dy/dx; not a number with fewer than two different abscissas.</summary>
        public double Slope => squaresX > 0.0 ? products / squaresX : double.NaN;

        /// <summary>Value at x = 0.</summary>
        public double Intercept => meanY - Slope * meanX;

        /// <summary>Adds a point.</summary>
        public void Add(double x, double y)
        {
            // Welford's sums about the means: no digits are lost when x is far from zero.
            count++;
            double dx = x - meanX;
            meanX += dx / count;
            meanY += (y - meanY) / count;
            squaresX += dx * (x - meanX);
            products += dx * (y - meanY);
        }
    }
}
