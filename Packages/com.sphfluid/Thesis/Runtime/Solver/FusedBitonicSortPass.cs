using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// The comparisons of <see cref="BitonicSortPass"/> in the same order, so with the same result, in a third of the dispatches: 65,536
    /// pairs take 11 in place of 34. Sorts in place, without a transpose.
    /// </summary>
    internal sealed class FusedBitonicSortPass : ComputePass
    {
        /// <summary>HELD of the shader: pairs that a group sorts.</summary>
        public const int Held = 2048;

        // A strip of 16 columns is 128 bytes of a row: less would leave part of what memory delivers at once unused.
        private const int MostRows = 128;

        private static readonly int Data = Id("_Data");
        private static readonly int Count = Id("_Count");
        private static readonly int Rows = Id("_Rows");
        private static readonly int FirstLevel = Id("_FirstLevel");
        private static readonly int LastLevel = Id("_LastLevel");
        private static readonly int LastDistance = Id("_LastDistance");

        private readonly ComputeKernel kernel;
        private readonly BitonicSortPass thesis;

        /// <param name="shaders">The shaders.</param>
        /// <param name="thesis">The thesis's sort, for distances that no strip reaches.</param>
        public FusedBitonicSortPass(FluidShaderSet shaders, BitonicSortPass thesis)
            : base(shaders, "FusedBitonicSort")
        {
            kernel = Kernel();
            this.thesis = thesis;
        }

        public void Record(CommandBuffer cmd, ThesisState state) => Record(cmd, state.Buffers.Grid, state.Buffers.PaddedCount);

        /// <param name="cmd">Command buffer.</param>
        /// <param name="data">The pairs, sorted in place.</param>
        /// <param name="count">Number of pairs: a power of two, see <see cref="BitonicSortPass.PaddedCount"/>.</param>
        public void Record(CommandBuffer cmd, GraphicsBuffer data, int count)
        {
            using (Sample(cmd))
            {
                Dispatch(cmd, data, count, 1, 2, Held, 1);
                for (int level = 2 * Held; level <= count && level > 0; level <<= 1)
                {
                    int rows = Mathf.Min(level / Held, MostRows);
                    for (int distance = level >> 1; distance >= rows * Held; distance >>= 1)
                    {
                        thesis.RecordMerge(cmd, data, distance, level, count);
                    }

                    Dispatch(cmd, data, count, rows, level, level, Held / rows);
                    Dispatch(cmd, data, count, 1, level, level, 1);
                }
            }
        }

        private void Dispatch(CommandBuffer cmd, GraphicsBuffer data, int count, int rows, int firstLevel, int lastLevel, int lastDistance)
        {
            kernel.SetInt(cmd, Count, count);
            kernel.SetInt(cmd, Rows, rows);
            kernel.SetInt(cmd, FirstLevel, firstLevel);
            kernel.SetInt(cmd, LastLevel, lastLevel);
            kernel.SetInt(cmd, LastDistance, lastDistance);
            kernel.SetBuffer(cmd, Data, data);
            kernel.DispatchThreads(cmd, count / 2); // one for each two pairs
        }
    }
}
