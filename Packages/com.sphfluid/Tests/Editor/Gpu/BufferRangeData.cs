using System;
using System.Runtime.InteropServices;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Values of any kind in a part of a buffer of 32-bit words.</summary>
    internal static class BufferRangeData
    {
        public static void SetData<T>(this BufferRange range, T[] values) where T : struct
        {
            uint[] words = MemoryMarshal.Cast<T, uint>(values.AsSpan()).ToArray();
            ((GraphicsBuffer)range.Buffer).SetData(words, 0, range.Begin, words.Length);
        }

        public static T[] Read<T>(this BufferRange range, int count) where T : struct
        {
            var values = new T[count];
            var words = new uint[MemoryMarshal.Cast<T, uint>(values.AsSpan()).Length];
            ((GraphicsBuffer)range.Buffer).GetData(words, 0, range.Begin, words.Length);
            return MemoryMarshal.Cast<uint, T>(words.AsSpan()).ToArray();
        }
    }
}
