using System;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>A rigid mesh of a run that moves: along a path that the case gives, or as gravity and the liquid move it.</summary>
    public sealed class CaseBody
    {
        /// <summary>Its closed surface about its own origin [m].</summary>
        public TriangleMesh Mesh;

        /// <summary>Its origin at the start [m], simulation space: where the body floats, the centre of mass.</summary>
        public Vector3 Centre;

        /// <summary>Its displacement from the start [m] at a time [s], zero at zero; null for a body that floats.</summary>
        public Func<double, Vector3> Path;

        /// <summary>Mass of a body that floats [kg]. It heaves, surges and sways, and does not turn.</summary>
        public float Mass;

        /// <summary>Whether gravity and the liquid move it.</summary>
        public bool Floats => Path == null;

        /// <summary>Where a path has it at a time.</summary>
        public Vector3 At(double time) => Centre + Path(time);
    }
}
