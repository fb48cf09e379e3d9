using System.Runtime.InteropServices;
using UnityEngine;

namespace SphFluid
{
    /// <summary>The liquid's particle that is nearest to a place; the nearer image where the domain is periodic.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct FluidNearestResult
    {
        /// <summary>World position of its centre [m].</summary>
        public Vector3 Place;

        /// <summary>How far that is [m]; -1 where there is none within the distance asked.</summary>
        public float Distance;

        /// <summary>World velocity [m/s], in the domain's frame.</summary>
        public Vector3 Velocity;

        internal uint Generation;

        /// <summary>Whether there is one.</summary>
        public bool IsFound => Distance >= 0f;
    }
}
