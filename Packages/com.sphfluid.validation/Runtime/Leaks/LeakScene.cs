using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Surfaces of triangles, liquid at them, and how they move. SI, simulation space.</summary>
    internal sealed class LeakScene
    {
        /// <summary>Frames a second.</summary>
        public const int FrameRate = 60;

        /// <summary>Name on the command line and in tables.</summary>
        public string Name;

        /// <summary>Speed that the scene is about [m/s]: of the shaking, or of the jet; 0 where all starts at rest.</summary>
        public double Speed;

        /// <summary>The physics.</summary>
        public FluidSolverSettings Settings;

        /// <summary>Particles at the start.</summary>
        public FluidParticle[] Particles;

        /// <summary>The surfaces; the first is the one that the fields below are about.</summary>
        public readonly List<LeakBody> Bodies = new List<LeakBody> { new LeakBody() };

        /// <inheritdoc cref="LeakBody.Surface"/>
        public Vector3[] Surface
        {
            get => Bodies[0].Surface;
            set => Bodies[0].Surface = value;
        }

        /// <inheritdoc cref="LeakBody.Motion"/>
        public Func<int, LeakPose> Motion
        {
            get => Bodies[0].Motion;
            set => Bodies[0].Motion = value;
        }

        /// <inheritdoc cref="LeakBody.Stretches"/>
        public bool Stretches
        {
            get => Bodies[0].Stretches;
            set => Bodies[0].Stretches = value;
        }

        /// <summary>Length in frames.</summary>
        public int Frames;

        /// <summary>Whether the liquid is at rest in the end, so that how it lies at the surface can be measured.</summary>
        public bool Rests;

        /// <summary>False: the surfaces are not given to the solver, so that liquid goes through. For tests of the detectors.</summary>
        public bool Solid = true;

        /// <summary>
        /// Whether surfaces close on liquid that then has no place: as many may get through as a message says were squeezed.
        /// </summary>
        public bool MaySqueeze;

        /// <summary>Whether any surface moves.</summary>
        public bool Moves => Bodies.Any(b => b.Motion != null || b.Shape != null || b.Floats);

        /// <summary>Where the first surface is at the end of a frame.</summary>
        public LeakPose PoseAt(int frame) => Bodies[0].PoseAt(frame);
    }
}
