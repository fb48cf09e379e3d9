using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// Thesis 6.2.3 and Appendix A: bitonic sort of uint2 pairs by x, then y. Runs of 1,024 are sorted in shared memory;
    /// longer ones as a matrix of 1,024 columns: transpose, sort the columns, transpose, sort the rows.
    /// A column of more than 1,024 rows (above 1,024 × 1,024 pairs) is first merged at the distances it does not hold.
    /// </summary>
    internal sealed class BitonicSortPass : ComputePass
    {
        /// <summary>BIT_BSIZE of the shader.</summary>
        public const int BlockSize = 1024;

        private const int MaxCount = 1 << 30;

        private static readonly int Data = Id("_Data");
        private static readonly int Input = Id("_Input");
        private static readonly int Level = Id("_Level");
        private static readonly int LevelMask = Id("_LevelMask");
        private static readonly int Width = Id("_Width");
        private static readonly int Height = Id("_Height");
        private static readonly int MergeDistance = Id("_MergeDistance");

        private readonly ComputeKernel bitonicSort, matrixTranspose, bitonicMerge;

        public BitonicSortPass(FluidShaderSet shaders)
            : base(shaders, "BitonicSort")
        {
            bitonicSort = Kernel();
            matrixTranspose = Kernel("MatrixTranspose");
            bitonicMerge = Kernel("BitonicMerge");
        }

        /// <summary>Pairs to sort for a number of particles: the next power of two, a block at least. 5,003 gives 8,192.</summary>
        public static int PaddedCount(int count)
        {
            if (count > MaxCount)
            {
                throw new FluidDeviceException(
                    $"{count} particles are more than the sort can index, {MaxCount}. Use a larger particle spacing.");
            }

            return Mathf.NextPowerOfTwo(Mathf.Max(count, BlockSize));
        }

        public void Record(CommandBuffer cmd, ThesisState state) =>
            Record(cmd, state.Buffers.Grid, state.Buffers.GridTranspose, state.Buffers.PaddedCount);

        /// <param name="cmd">Command buffer.</param>
        /// <param name="data">The pairs, sorted in place.</param>
        /// <param name="temp">As many pairs again.</param>
        /// <param name="count">Number of pairs: a power of two, a block at least.</param>
        public void Record(CommandBuffer cmd, GraphicsBuffer data, GraphicsBuffer temp, int count)
        {
            using (Sample(cmd))
            {
                for (int level = 2; level <= BlockSize; level <<= 1) SortRows(cmd, data, level, level, count);

                for (int level = BlockSize << 1; level <= count && level > 0; level <<= 1) RecordLevel(cmd, data, temp, level, count);
            }
        }

        /// <summary>Sorts runs of a length, halves of which go up and down by turns.</summary>
        /// <param name="cmd">Command buffer.</param>
        /// <param name="data">The pairs, sorted in place.</param>
        /// <param name="temp">As many pairs again.</param>
        /// <param name="level">Length of the runs, a power of two above a block.</param>
        /// <param name="count">Number of pairs, a power of two.</param>
        public void RecordLevel(CommandBuffer cmd, GraphicsBuffer data, GraphicsBuffer temp, int level, int count)
        {
            int width = BlockSize, height = count / BlockSize;
            for (int distance = level >> 1; distance >= BlockSize * BlockSize; distance >>= 1)
            {
                RecordMerge(cmd, data, distance, level & ~count, count);
            }

            // level & ~count: the last level of all runs upwards everywhere.
            Transpose(cmd, data, temp, width, height);
            SortRows(cmd, temp, Mathf.Min(level / BlockSize, BlockSize), (level & ~count) / BlockSize, count);
            Transpose(cmd, temp, data, height, width);
            SortRows(cmd, data, BlockSize, level & ~count, count);
        }

        private void SortRows(CommandBuffer cmd, GraphicsBuffer data, int level, int levelMask, int count)
        {
            bitonicSort.SetInt(cmd, Level, level);
            bitonicSort.SetInt(cmd, LevelMask, levelMask);
            bitonicSort.SetBuffer(cmd, Data, data);
            bitonicSort.DispatchThreads(cmd, count);
        }

        private void Transpose(CommandBuffer cmd, GraphicsBuffer from, GraphicsBuffer to, int width, int height)
        {
            matrixTranspose.SetInt(cmd, Width, width);
            matrixTranspose.SetInt(cmd, Height, height);
            matrixTranspose.SetBuffer(cmd, Input, from);
            matrixTranspose.SetBuffer(cmd, Data, to);
            matrixTranspose.DispatchThreads(cmd, width, height, 1);
        }

        /// <summary>One comparison of a level.</summary>
        /// <param name="cmd">Command buffer.</param>
        /// <param name="data">The pairs.</param>
        /// <param name="distance">Between the two of each comparison, a power of two.</param>
        /// <param name="levelMask">The level; runs of this length go up and down by turns.</param>
        /// <param name="count">Number of pairs, a power of two.</param>
        public void RecordMerge(CommandBuffer cmd, GraphicsBuffer data, int distance, int levelMask, int count)
        {
            bitonicMerge.SetInt(cmd, MergeDistance, distance);
            bitonicMerge.SetInt(cmd, LevelMask, levelMask);
            bitonicMerge.SetBuffer(cmd, Data, data);
            bitonicMerge.DispatchThreads(cmd, count / 2);
        }
    }
}
