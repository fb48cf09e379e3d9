using System;
using System.Runtime.InteropServices;

namespace SphFluid
{
    /// <summary>
    /// FNV-1a with 64 bits (Fowler, Noll, Vo; the IETF draft draft-eastlake-fnv). Worked example: of the ASCII letter a it is
    /// 0xAF63DC4C8601EC8C.
    /// </summary>
    internal static class StateHash
    {
        private const ulong Offset = 0xCBF29CE484222325ul, Prime = 0x100000001B3ul;

        /// <summary>The hash of items that follow others.</summary>
        public static ulong Compute<T>(ReadOnlySpan<T> items, ulong before = Offset) where T : unmanaged
        {
            ulong hash = before;
            foreach (byte value in MemoryMarshal.AsBytes(items)) hash = unchecked((hash ^ value) * Prime);
            return hash;
        }

        /// <summary>Waits for the GPU and hashes a liquid: its particles by number, and the bodies that it moves.</summary>
        public static ulong Compute(FluidSolver solver)
        {
            ulong hash = Compute(new ReadOnlySpan<FluidParticle>(SavedParticles.Read(solver)));
            FloatingBodies floating = solver.State.Bodies?.Floating;
            return floating == null || floating.Count == 0 ? hash : Compute(new ReadOnlySpan<FloatingState>(floating.ReadNow()), hash);
        }
    }
}
