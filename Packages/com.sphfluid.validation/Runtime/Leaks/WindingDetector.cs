using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// For closed surfaces that stretch, deform or float: a particle whose winding number, rounded, is another than at the start has
    /// escaped. A place that is not finite has.
    /// </summary>
    internal sealed class WindingDetector : LeakDetector
    {
        private WindingNumber winding;
        private readonly List<double> start = new List<double>();

        public WindingDetector(Vector3[] corners) => winding = new WindingNumber(corners);

        /// <inheritdoc/>
        public override bool NeedsSteps => false;

        /// <inheritdoc/>
        public override void Reshape(Vector3[] corners) => winding = new WindingNumber(corners);

        /// <inheritdoc/>
        protected override bool Passed(int particle, Vector3 place, bool first)
        {
            double now = Math.Round(winding.At(place));
            if (first) start.Add(now);
            return now != start[particle]; // NaN too
        }
    }
}
