using System;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>A surface of triangles and how it moves. SI, simulation space.</summary>
    internal sealed class LeakBody
    {
        /// <summary>The surface in its own space [m], three corners a triangle; Cross(B − A, C − A) outward where it is closed.</summary>
        public Vector3[] Surface;

        /// <summary>
        /// Where the surface is at the end of a frame; frame 0 is the start. Null: it rests. Of a body that floats only the start counts.
        /// </summary>
        public Func<int, LeakPose> Motion;

        /// <summary>
        /// Corners of the same triangles in the surface's own space at the end of a frame [m]; null: those of <see cref="Surface"/>.
        /// </summary>
        public Func<int, Vector3[]> Shape;

        /// <summary>Whether the surface's scale or shear changes.</summary>
        public bool Stretches;

        /// <summary>Mass of a body that the liquid moves about the origin of its own space [kg]; 0: it goes where it is put.</summary>
        public float Mass;

        /// <summary>Moments of inertia of a floating body about its own axes [kg m²].</summary>
        public Vector3 Inertia;

        /// <summary>
        /// What a floating body is pushed by before a frame: velocity [m/s] and angular velocity [rad/s] that are added; null: nothing.
        /// </summary>
        public Func<int, (Vector3 velocity, Vector3 spin)> Push;

        /// <summary>The surface as a mesh.</summary>
        public TriangleMesh Mesh => TriangleMesh.FromCorners(Surface);

        /// <summary>Whether it is known at the ends of frames only.</summary>
        public bool IsFreeWithinFrames => Stretches || Shape != null || Floats;

        /// <summary>Whether the liquid moves it.</summary>
        public bool Floats => Mass > 0f;

        public LeakPose PoseAt(int frame) => Motion?.Invoke(frame) ?? LeakPose.Rest;
    }
}
