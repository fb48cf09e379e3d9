using System;
using System.Linq;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>A surface of triangles, liquid at it, and how the surface moves. SI, simulation space.</summary>
    sealed class LeakScene
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

        /// <summary>The surface in its own space [m], three corners a triangle; Cross(B − A, C − A) outward where it is closed.</summary>
        public Vector3[] Surface;

        /// <summary>Length in frames.</summary>
        public int Frames;

        /// <summary>Where the surface is at the end of a frame; frame 0 is the start. Null: it rests.</summary>
        public Func<int, LeakPose> Motion;

        /// <summary>Whether the surface's scale or shear changes.</summary>
        public bool Stretches;

        /// <summary>Whether the liquid is at rest in the end, so that how it lies at the surface can be measured.</summary>
        public bool Rests;

        /// <summary>False: the surface is not given to the solver, so that liquid goes through. For tests of the detectors.</summary>
        public bool Solid = true;

        /// <summary>The surface as a mesh.</summary>
        public TriangleMesh Mesh => TriangleMesh.FromCorners(Surface);

        public LeakPose PoseAt(int frame) => Motion?.Invoke(frame) ?? LeakPose.Rest;
    }
}
