using System;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// Y. Zhu and R. Bridson, "Animating sand as a fluid" (2005): the distance of a point from the weighted mean of the particles around it, by
    /// the weights (1 − q²)³. Here 1 − distance/R, so that the liquid has the larger values.
    /// </summary>
    sealed class ZhuBridsonField : ParticleField
    {
        /// <inheritdoc/>
        public override float[] Sample(NeighbourSums particles, SurfaceGrid grid)
        {
            var weights = new double[grid.VertexCount];
            var sums = new Vector3[grid.VertexCount];
            float radius = particles.Radius;
            foreach (Vector3 position in particles.Positions)
            {
                EachVertex(grid, position, radius * Vector3.one, (vertex, apart) =>
                {
                    float t = 1f - apart.sqrMagnitude / (radius * radius);
                    if (t <= 0f)
                        return;
                    weights[vertex] += t * t * t;
                    sums[vertex] += t * t * t * apart;
                });
            }
            var values = new float[grid.VertexCount];
            for (int i = 0; i < values.Length; i++)
                values[i] = weights[i] > 0.0 ? Math.Max(0f, 1f - sums[i].magnitude / (float)weights[i] / radius) : 0f;
            return values;
        }
    }
}
