using System.Runtime.InteropServices;
using UnityEngine;

namespace SphFluid
{
    /// <summary>A vertex of the sparse surface; mirrors the struct of Shaders/Surface/Sparse/PackedSurfaceVertex.hlsl.</summary>
    [StructLayout(LayoutKind.Sequential)]
    struct PackedSurfaceVertex
    {
        /// <summary>Bytes of one element.</summary>
        public const int Stride = 16;

        const float Largest = 32767f;

        /// <summary>Position [m], simulation space.</summary>
        public Vector3 Position;

        /// <summary>Octahedral normal out of the liquid, 16 bits x (low) and 16 bits y.</summary>
        public uint PackedNormal;

        /// <summary>Unit normal out of the liquid.</summary>
        public Vector3 Normal
        {
            get
            {
                float x = (short)(PackedNormal & 0xffff) / Largest;
                float y = (short)(PackedNormal >> 16) / Largest;
                float z = 1f - Mathf.Abs(x) - Mathf.Abs(y);
                float fold = Mathf.Max(-z, 0f);
                return new Vector3(x - (x >= 0f ? fold : -fold), y - (y >= 0f ? fold : -fold), z).normalized;
            }
        }
    }
}
