using System;
using System.Runtime.InteropServices;

namespace SphFluid
{
    /// <summary>What a liquid is given in a frame, and its state after it: 24 bytes in a recording.</summary>
    [StructLayout(LayoutKind.Sequential)]
    internal struct FluidFrame
    {
        public const int Size = 24;

        /// <summary>Time that it goes on by [s].</summary>
        public double Time;

        /// <summary>Hash of its state after the frame.</summary>
        public ulong Hash;

        /// <summary>Steps that it takes besides, one by one.</summary>
        public int SingleSteps;

        /// <summary>CRC-32 of the other numbers.</summary>
        public uint Check;

        /// <summary>The frame as a recording has it.</summary>
        public readonly ReadOnlySpan<byte> Bytes => SaveWriter.BytesOf(this);

        /// <summary>The check that the numbers ask for.</summary>
        public readonly uint Expected => Crc32.Compute(Bytes.Slice(0, Size - sizeof(uint)));
    }

    /// <summary>Sees, or settles, what a liquid is given in each frame.</summary>
    internal interface IFluidFrames
    {
        /// <summary>What the liquid is given instead of a frame of the scene.</summary>
        FluidFrame Take(in FluidFrame frame);
    }
}
