using System.Collections.Generic;

namespace SphFluid.Validation
{
    /// <summary>A curve of a run for its picture.</summary>
    public sealed class CaseSeries
    {
        /// <summary>An empty curve.</summary>
        /// <param name="name">Name in the legend.</param>
        /// <param name="isReference">Whether it is what the run should give.</param>
        public CaseSeries(string name, bool isReference = false)
        {
            Name = name;
            IsReference = isReference;
        }

        /// <summary>Name in the legend.</summary>
        public string Name { get; }

        /// <summary>Whether it is what the run should give.</summary>
        public bool IsReference { get; }

        /// <summary>Abscissas.</summary>
        public List<double> X { get; } = new List<double>();

        /// <summary>Ordinates.</summary>
        public List<double> Y { get; } = new List<double>();

        /// <summary>
        /// Upper edge where this is a band, for instance of experiments, whose lower edge is <see cref="Y"/>, behind the reference of its
        /// name; empty for a curve.
        /// </summary>
        public List<double> Upper { get; } = new List<double>();

        /// <summary>Whether it is a band.</summary>
        public bool IsBand => Upper.Count > 0;

        /// <summary>Adds a point.</summary>
        public void Add(double x, double y)
        {
            X.Add(x);
            Y.Add(y);
        }

        /// <summary>Adds a place of a band.</summary>
        public void AddBand(double x, double low, double high)
        {
            Add(x, low);
            Upper.Add(high);
        }
    }
}
