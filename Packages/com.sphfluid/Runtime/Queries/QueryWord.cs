using System;
using System.Runtime.InteropServices;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// A vector and a number, of which queries consist on the GPU; mirrored by QueryWord in Shaders/Queries/QuerySpace.hlsl.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    internal struct QueryWord
    {
        public const int Stride = 16;

        public Vector3 Vector;
        public uint Number;

        public QueryWord(Vector3 vector, float number)
        {
            Vector = vector;
            Number = unchecked((uint)BitConverter.SingleToInt32Bits(number));
        }
    }
}
