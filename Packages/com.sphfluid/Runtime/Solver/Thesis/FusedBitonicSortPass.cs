using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// The comparisons of <see cref="BitonicSortPass"/> in the same order, so with the same result, in a third of the dispatches: 65,536 pairs
    /// take 11 in place of 34. Sorts in place, without a transpose.
    /// </summary>
    internal sealed class FusedBitonicSortPass : ComputePass
    {
        /// <summary>RUN of the shader: pairs that a group holds.</summary>
        public const int Run = 2048;

        // A strip of 16 columns is 128 bytes of a row: less would leave part of what memory delivers at once unused.
        const int MostRows = 128;

        static readonly int Data = Id("_Data");
        static readonly int Count = Id("_Count");
        static readonly int Level = Id("_Level");
        static readonly int Rows = Id("_Rows");
        static readonly int MergeDistance = Id("_MergeDistance");

        readonly ComputeKernel sortRuns, mergeColumns, mergeRuns, mergePairs;

        public FusedBitonicSortPass(FluidShaderSet shaders)
            : base(shaders, "FusedBitonicSort")
        {
            sortRuns = Kernel();
            mergeColumns = Kernel("MergeColumns");
            mergeRuns = Kernel("MergeRuns");
            mergePairs = Kernel("MergePairs");
        }

        public void Record(CommandBuffer cmd, ThesisState state) => Record(cmd, state.Buffers.Grid, state.Buffers.PaddedCount);

        /// <param name="cmd">Command buffer.</param>
        /// <param name="data">The pairs, sorted in place.</param>
        /// <param name="count">Number of pairs: a power of two, see <see cref="BitonicSortPass.PaddedCount"/>.</param>
        public void Record(CommandBuffer cmd, GraphicsBuffer data, int count)
        {
            using (Sample(cmd))
            {
                Dispatch(cmd, sortRuns, data, count);
                for (int level = 2 * Run; level <= count && level > 0; level <<= 1)
                {
                    int rows = Mathf.Min(level / Run, MostRows);
                    for (int distance = level >> 1; distance >= rows * Run; distance >>= 1)
                    {
                        mergePairs.SetInt(cmd, Level, level);
                        mergePairs.SetInt(cmd, MergeDistance, distance);
                        Dispatch(cmd, mergePairs, data, count);
                    }

                    mergeColumns.SetInt(cmd, Level, level);
                    mergeColumns.SetInt(cmd, Rows, rows);
                    Dispatch(cmd, mergeColumns, data, count);
                    mergeRuns.SetInt(cmd, Level, level);
                    Dispatch(cmd, mergeRuns, data, count);
                }
            }
        }

        // A thread for each two pairs.
        void Dispatch(CommandBuffer cmd, ComputeKernel kernel, GraphicsBuffer data, int count)
        {
            kernel.SetInt(cmd, Count, count);
            kernel.SetBuffer(cmd, Data, data);
            kernel.DispatchThreads(cmd, count / 2);
        }
    }
}
