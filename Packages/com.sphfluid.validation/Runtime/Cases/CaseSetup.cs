using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>A run that is ready to start: constants, particles, obstacles, length. SI, simulation space.</summary>
    public sealed class CaseSetup
    {
        /// <summary>The physics, and the method.</summary>
        public FluidSolverSettings Settings;

        /// <summary>Particles at the start.</summary>
        public FluidParticle[] Particles;

        /// <summary>Length of the run [s].</summary>
        public double Duration;

        /// <summary>Time between two samples of the metric [s].</summary>
        public double SampleInterval;

        /// <summary>Closed obstacles, three corners a triangle, outward by the left-hand rule as Unity's meshes; empty for none.</summary>
        public IReadOnlyList<Vector3[]> Obstacles = System.Array.Empty<Vector3[]>();

        /// <summary>Bodies that move, in an order that the metric knows; empty for none.</summary>
        public IReadOnlyList<CaseBody> Bodies = System.Array.Empty<CaseBody>();

        /// <summary>
        /// Rectangles of walls whose mean pressure the metric is told, in an order that it knows, where the method measures the force on
        /// walls; empty for none.
        /// </summary>
        public IReadOnlyList<CasePatch> Patches = System.Array.Empty<CasePatch>();

        /// <summary>True: the faces of the domain are out of the liquid's reach, and liquid that comes there is lost.</summary>
        public bool IsOpen;

        /// <summary>A speed that no right answer has [m/s], three times the fastest for instance: with it a run has failed.</summary>
        public double SpeedLimit = double.PositiveInfinity;
    }
}
