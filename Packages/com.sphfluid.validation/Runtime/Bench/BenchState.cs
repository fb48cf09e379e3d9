using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>A settled liquid from which samples start, and what the searches find in it.</summary>
    internal sealed class BenchState
    {
        private readonly Dictionary<float, double> neighbours = new Dictionary<float, double>();
        private readonly Vector3[] positions;

        public BenchState(FluidParticle[] particles)
        {
            Particles = particles;
            positions = Array.ConvertAll(particles, p => p.Position);
        }

        public FluidParticle[] Particles { get; }

        /// <summary>k: mean number of other particles within R [m].</summary>
        public double NeighboursMean(float radius)
        {
            if (!neighbours.TryGetValue(radius, out double mean)) neighbours.Add(radius, mean = NeighbourCount.Of(positions, radius).Mean);
            return mean;
        }

        /// <summary>Mean number of particles that a solver's search looks at.</summary>
        public double CandidatesMean(FluidSolver solver) => CandidateCount.Mean(positions, solver.Grid, solver.Settings.OctantSearch);
    }
}
