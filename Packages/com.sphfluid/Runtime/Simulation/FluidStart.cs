using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>First particles of a simulation and how far and fast its liquid can fall.</summary>
    internal sealed class FluidStart
    {
        public FluidStart(List<FluidParticle> particles, long count, LiquidExtent extent, float initialSpeed)
        {
            InitialSpeed = initialSpeed;
            Particles = particles;
            Count = count;
            Extent = extent;
        }

        /// <summary>The particles; empty when only a check was asked for.</summary>
        public List<FluidParticle> Particles { get; }

        /// <summary>Their number.</summary>
        public long Count { get; }

        public LiquidExtent Extent { get; }

        /// <summary>Largest speed of a particle at the start [m/s].</summary>
        public float InitialSpeed { get; }

        /// <summary>Gravity at the start in simulation space [m/s²].</summary>
        public Vector3 Gravity { get; set; }

        /// <summary>The method that was chosen; null where it is given.</summary>
        public FluidMethodChoice Choice { get; set; }

        /// <summary>The simulation as it starts, by the choice.</summary>
        public FluidSpec Resolve(in FluidSpec spec) => Choice == null ? spec : Choice.Apply(spec);

        /// <summary>The solver's constants with the present settings.</summary>
        public FluidSolverSettings Constants { get; set; }
    }
}
