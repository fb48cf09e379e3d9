using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Particles with mirror images behind the walls of the domain, and how each one's neighbourhood lies: count, mean and covariance by the weights 1 − q³ (Yu and Turk 2010).</summary>
    sealed class NeighbourSums
    {
        // R/dx: 33 particles of a lattice, as the sparse surface's smooth field has them.
        const float SupportRatio = 2f;

        /// <summary>Gathers.</summary>
        /// <param name="positions">Particles [m].</param>
        /// <param name="settings">Domain and spacing; no periodic axes.</param>
        public NeighbourSums(Vector3[] positions, in FluidSolverSettings settings)
        {
            Radius = SupportRatio * settings.Spacing;
            Spacing = settings.Spacing;
            Positions = WithImages(positions, 0.5f * settings.DomainSize, 2f * Radius);
            Counts = new int[Positions.Length];
            Means = new Vector3[Positions.Length];
            Covariances = new SymmetricTensor[Positions.Length];
            var cells = new CellLists(Positions, Radius);
            for (int i = 0; i < Positions.Length; i++)
                Gather(cells, i);
        }

        /// <summary>Support radius R [m].</summary>
        public float Radius { get; }

        /// <summary>dx [m].</summary>
        public float Spacing { get; }

        /// <summary>Particles and images [m].</summary>
        public Vector3[] Positions { get; }

        /// <summary>Others within R of each.</summary>
        public int[] Counts { get; }

        /// <summary>Weighted mean position of the neighbourhood less the particle's own [m].</summary>
        public Vector3[] Means { get; }

        /// <summary>Weighted covariance of the neighbourhood [m²].</summary>
        public SymmetricTensor[] Covariances { get; }

        void Gather(CellLists cells, int particle)
        {
            double weights = 0.0;
            var sum = Vector3.zero;
            var squares = new SymmetricTensor();
            foreach (int other in cells.Around(Positions[particle]))
            {
                Vector3 apart = Positions[other] - Positions[particle];
                float q = apart.magnitude / Radius;
                if (q >= 1f)
                    continue;
                float weight = 1f - q * q * q;
                weights += weight;
                sum += weight * apart;
                squares = squares.PlusOuter(apart, weight);
                Counts[particle] += other != particle ? 1 : 0;
            }
            Means[particle] = sum / (float)weights;
            Covariances[particle] = squares.Times(1.0 / weights).PlusOuter(Means[particle], -1.0);
        }

        // As if the liquid went on behind walls: what lies within reach of one is mirrored there, in corners twice and thrice.
        static Vector3[] WithImages(Vector3[] positions, Vector3 half, float reach)
        {
            var all = new List<Vector3>(positions);
            for (int axis = 0; axis < 3; axis++)
            {
                int count = all.Count;
                for (int i = 0; i < count; i++)
                {
                    Vector3 image = all[i];
                    if (half[axis] - Math.Abs(image[axis]) > reach)
                        continue;
                    image[axis] = (image[axis] < 0f ? -2f : 2f) * half[axis] - image[axis];
                    all.Add(image);
                }
            }
            return all.ToArray();
        }
    }
}
