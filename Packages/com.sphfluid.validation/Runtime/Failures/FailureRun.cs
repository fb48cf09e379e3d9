using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>One side of a <see cref="FailureExperiment"/>, ready to start. SI, simulation space.</summary>
    public sealed class FailureRun
    {
        /// <summary>The physics.</summary>
        public FluidSolverSettings Settings;

        /// <summary>Particles at the start.</summary>
        public FluidParticle[] Start;

        /// <summary>Number of steps; zero: the start alone is looked at.</summary>
        public int Steps;

        /// <summary>How often the run is looked at besides the start, at equal numbers of steps.</summary>
        public int Samples = 20;

        /// <summary>Kinematic viscosity of the liquid that is meant [m²/s]; NaN where none is.</summary>
        public double RealViscosity = double.NaN;

        /// <summary>Obstacles that may be open, three corners a triangle, outward by the left-hand rule as Unity's meshes.</summary>
        public IReadOnlyList<Vector3[]> Sheets = Array.Empty<Vector3[]>();

        /// <summary>Searches 8 cells although the cells are R wide: the octant's rule with the wrong size.</summary>
        public bool EightCellsOfRadius;

        /// <summary>
        /// The ranges of the cells are not emptied between two sorts. The run must have no steps: the liquid is moved to
        /// <see cref="Later"/> and sorted once more.
        /// </summary>
        public bool RangesKept;

        /// <summary>Where the particles are before the second sort; null: there is one sort.</summary>
        public FluidParticle[] Later;

        /// <summary>The same with other settings.</summary>
        /// <param name="settings">The physics.</param>
        public FailureRun With(in FluidSolverSettings settings)
        {
            var run = (FailureRun)MemberwiseClone();
            run.Settings = settings;
            return run;
        }

        /// <summary>The same from other particles.</summary>
        /// <param name="start">Particles at the start.</param>
        public FailureRun From(FluidParticle[] start)
        {
            var run = (FailureRun)MemberwiseClone();
            run.Start = start;
            return run;
        }
    }
}
