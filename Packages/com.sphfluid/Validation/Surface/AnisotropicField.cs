using System;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// J. Yu and G. Turk, "Reconstructing surfaces of particle-based fluids using anisotropic kernels" (2010): poly6 kernels about smoothed
    /// positions, stretched along the principal axes of each neighbourhood. Each kernel keeps its volume, where the paper scales all by one
    /// constant that does so in a full neighbourhood.
    /// </summary>
    sealed class AnisotropicField : ParticleField
    {
        // Of the paper: λ = 0.9 and k_r = 4; with the 33 neighbours of R = 2 dx fewer than 7 make a drop, whose kernel is half as wide.
        const float Smoothing = 0.9f;
        const double LargestRatio = 4.0, DropScale = 0.5;
        const int FewNeighbours = 6;

        // Of the square of dx: particles at one point have no axes.
        const double LeastTrace = 1e-6;

        readonly double[] axes = new double[3];
        readonly Vector3[] directions = new Vector3[3];

        /// <inheritdoc/>
        public override float[] Sample(NeighbourSums particles, SurfaceGrid grid)
        {
            var values = new float[grid.VertexCount];
            double radius = particles.Radius;
            double height = 315.0 / (64.0 * Math.PI) * Math.Pow(particles.Spacing / radius, 3.0);
            for (int i = 0; i < particles.Positions.Length; i++)
            {
                SymmetricTensor stretch = Stretch(particles, i, out Vector3 extent, out double density);
                Vector3 centre = particles.Positions[i] + Smoothing * particles.Means[i];
                EachVertex(grid, centre, particles.Radius * extent, (vertex, apart) =>
                {
                    double t = 1.0 - stretch.Form(apart) / (radius * radius);
                    if (t > 0.0)
                        values[vertex] += (float)(density * height * t * t * t);
                });
            }
            return values;
        }

        // The matrix M of q² = rᵀ M r / R², the half edges over R of the box around q < 1, and the kernel's height over the undistorted one's.
        SymmetricTensor Stretch(NeighbourSums particles, int particle, out Vector3 extent, out double density)
        {
            SymmetricTensor covariance = particles.Covariances[particle];
            if (particles.Counts[particle] <= FewNeighbours || covariance.Trace <= LeastTrace * particles.Spacing * particles.Spacing)
            {
                extent = (float)DropScale * Vector3.one;
                density = 1.0 / (DropScale * DropScale * DropScale);
                double inverse = 1.0 / (DropScale * DropScale);
                return new SymmetricTensor(inverse, inverse, inverse, 0.0, 0.0, 0.0);
            }
            covariance.Eigen(axes, directions);
            double largest = Math.Max(axes[0], Math.Max(axes[1], axes[2]));
            for (int k = 0; k < 3; k++)
                axes[k] = Math.Max(axes[k], largest / LargestRatio);
            double scale = Math.Pow(axes[0] * axes[1] * axes[2], -1.0 / 3.0);
            var matrix = new SymmetricTensor();
            Vector3 squared = Vector3.zero;
            for (int k = 0; k < 3; k++)
            {
                double length = scale * axes[k];
                matrix = matrix.PlusOuter(directions[k], 1.0 / (length * length));
                squared += (float)(length * length) * Vector3.Scale(directions[k], directions[k]);
            }
            extent = new Vector3(Mathf.Sqrt(squared.x), Mathf.Sqrt(squared.y), Mathf.Sqrt(squared.z));
            density = 1.0;
            return matrix;
        }
    }
}
