using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// For closed surfaces: a particle is inside where the crossings of a ray, counted by their direction, sum to more than none. The sides
    /// of edges are decided in double precision, and alike for both triangles of an edge, so no ray slips between two.
    /// </summary>
    internal sealed class InsideDetector : LeakDetector
    {
        private readonly TriangleMesh mesh;
        private readonly Dictionary<int, bool> startedInside = new Dictionary<int, bool>();

        public InsideDetector(TriangleMesh mesh) => this.mesh = mesh;

        /// <inheritdoc/>
        public override bool NeedsSteps => false;

        /// <inheritdoc/>
        protected override bool Passed(int particle, Vector3 place, bool first)
        {
            bool inside = mesh.Contains(place);
            if (first) startedInside[particle] = inside;
            return inside != startedInside[particle];
        }
    }
}
