using System.Runtime.InteropServices;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// A triangle's corner as EmitSurfaceVertices.compute writes it; mirrors the struct of EmittedVertex.hlsl.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    struct EmittedVertex
    {
        /// <summary>Bytes of one element.</summary>
        public const int Stride = 32;

        /// <summary>Position [m], simulation space.</summary>
        public Vector3 Position;

        /// <summary>Name of the grid edge it lies on, the same in all cubes around that edge.</summary>
        public uint Edge;

        /// <summary>Unit normal out of the liquid.</summary>
        public Vector3 Normal;

        /// <summary>Number of the cube that emitted it.</summary>
        public uint Cube;
    }
}
