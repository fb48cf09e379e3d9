using System.Runtime.InteropServices;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// A rigid body on the GPU; mirrored by FloatingState in Shaders/Collision/FloatingBodies.hlsl. Simulation space, SI.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    internal struct FloatingState
    {
        public const int Stride = 96;

        public Quaternion Rotation;
        public Vector3 Centre;
        public uint Epoch;
        public Vector3 Velocity;
        public float Time;
        public Vector3 AngularVelocity;
        public float Layer;
        public Vector3 Impulse;
        public float Unused1;
        public Vector3 AngularImpulse;
        public float Unused2;

        public FloatingPose Pose => new FloatingPose(Centre, Rotation);
    }

    /// <summary>What the owner of a body says once a frame; mirrored by FloatingInput in Shaders/Collision/FloatingInput.hlsl.</summary>
    [StructLayout(LayoutKind.Sequential)]
    internal struct FloatingInput
    {
        public const int Stride = 208;

        /// <summary>Bit of <see cref="Flags"/>: the state begins anew at this pose and these velocities.</summary>
        public const uint Seeds = 1u;

        /// <summary>
        /// Bits of <see cref="Flags"/>: it moves as one with others that it rests on or that rest on it; it is the first of them.
        /// </summary>
        public const uint Joined = 2u, Leads = 4u;

        public Quaternion Rotation;
        public Vector3 Centre;
        public uint Epoch;
        public Vector3 Velocity;
        public uint Flags;
        public Vector3 AngularVelocity;
        public float InverseMass;
        public Vector3 InverseInertia;
        public uint FirstPart;
        public Vector3 Gravity;
        public uint PartCount;
        public Vector3 FreeX;
        public float Damping;
        public Vector3 FreeY;
        public float AngularDamping;
        public Vector3 FreeZ;
        public float MostPull;
        public Vector3 PushVelocity;
        public float MostSpeed;
        public Vector3 PushAngularVelocity;
        public float TurnsPerMetre;
        public Vector3 PushDisplacement;
        public uint Next;
        public Vector3 PushRotation;
        public float Layer;
    }

    /// <summary>A collider of a body; mirrored by FloatingPart in Shaders/Collision/FloatingInput.hlsl.</summary>
    [StructLayout(LayoutKind.Sequential)]
    internal struct FloatingPart
    {
        public const int Stride = 32;

        public Quaternion Rotation;
        public Vector3 Position;
        public uint Body;
    }
}
