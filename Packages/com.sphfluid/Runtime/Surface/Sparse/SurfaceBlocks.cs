using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// Slots of the sparse surface's counters on the GPU: Shaders/Surface/Sparse/SurfaceCounters.hlsl.
    /// </summary>
    internal static class SurfaceCounters
    {
        public const int Slots = 16;

        /// <summary>Blocks that need a slot, those of the late round included.</summary>
        public const int BlocksRequested = 0;

        /// <summary>Blocks of the first round; 0 where not all fit.</summary>
        public const int BlocksListed = 1;

        /// <summary>Blocks of the late round.</summary>
        public const int BlocksLate = 2;

        /// <summary>First slot of the present round.</summary>
        public const int RoundFirst = 3;

        /// <summary>Slots of the present round.</summary>
        public const int RoundCount = 4;

        /// <summary>Vertices of all listed blocks.</summary>
        public const int VerticesRequested = 5;

        /// <summary>Indices of all listed blocks.</summary>
        public const int IndicesRequested = 6;

        /// <summary>
        /// Faces of blocks that the surface crosses towards a block without a slot, after the late round.
        /// </summary>
        public const int OpenFaces = 7;

        /// <summary>Particles that are skipped: their position is not a number.</summary>
        public const int NonFinite = 8;

        /// <summary>1 where the surface fitted the buffers and was emitted.</summary>
        public const int Complete = 9;

        /// <summary>Number of the recording.</summary>
        public const int Number = 10;
    }

    /// <summary>
    /// Blocks of 8³ cubes over a surface grid, of which only those near the surface hold samples: a table over all
    /// blocks, and slots (Shaders/Surface/Sparse/SurfaceBlocks.hlsl). Cubes and samples count the ring that closes the
    /// surface at the walls.
    /// </summary>
    internal sealed class SurfaceBlocks : BufferSet
    {
        /// <summary>Cubes of a block along an axis.</summary>
        public const int CubesPerSide = 8;

        /// <summary>Samples of a block along an axis: neighbours share a layer, each stores its own.</summary>
        public const int SamplesPerSide = CubesPerSide + 1;

        /// <summary>Samples of a block.</summary>
        public const int SamplesPerBlock = SamplesPerSide * SamplesPerSide * SamplesPerSide;

        // First vertex, vertex count, first index, index count.
        private const int RangeStride = 4 * sizeof(uint);

        private static readonly int BlockCountsId = Shader.PropertyToID("_BlockCounts");
        private static readonly int BlockCapacityId = Shader.PropertyToID("_BlockCapacity");

        // Copied when recorded, so one array serves; command buffers are recorded on the main thread.
        [OutlivesPlay("it is filled anew for each use")] private static readonly int[] CountsValue = new int[3];

        private FluidBuffer table, list, samples, ranges, counters, roundArguments;

        /// <summary>Blocks along each axis; zero before <see cref="Reserve"/>.</summary>
        public Vector3Int Counts { get; private set; }

        /// <summary>Number of blocks of the grid, active or not.</summary>
        public int BlockCount => Counts.x * Counts.y * Counts.z;

        /// <summary>Slots: blocks that can hold samples at once.</summary>
        public int Capacity { get; private set; }

        /// <summary>uint a block of the grid: 0, <c>BLOCK_MARKED</c>, or slot + 1.</summary>
        public FluidBuffer Table => table;

        /// <summary>uint a slot: number of its block, x fastest.</summary>
        public FluidBuffer List => list;

        /// <summary>
        /// Field values, float, <see cref="SamplesPerBlock"/> a slot, x fastest; the surface is where they equal the
        /// iso value.
        /// </summary>
        public FluidBuffer Samples => samples;

        /// <summary>uint4 a slot: first vertex, vertices, first index, indices.</summary>
        public FluidBuffer Ranges => ranges;

        /// <summary>uint each, see <see cref="SurfaceCounters"/>.</summary>
        public FluidBuffer Counters => counters;

        /// <summary>Groups along x, y and z of a dispatch with a group a slot of the present round.</summary>
        public FluidBuffer RoundArguments => roundArguments;

        /// <summary>Most slots that buffers of this device, and 32-bit sample numbers, allow.</summary>
        public static int DeviceCapacity =>
            (int)(Math.Min(SystemInfo.maxGraphicsBufferSize / sizeof(float), uint.MaxValue) / SamplesPerBlock);

        /// <summary>Blocks that a grid has along each axis.</summary>
        /// <param name="cells">Cells of the grid along each axis.</param>
        public static Vector3Int CountsOver(Vector3Int cells) =>
            new Vector3Int(CountOver(cells.x), CountOver(cells.y), CountOver(cells.z));

        /// <summary>Makes the buffers large enough; what they held may be lost.</summary>
        /// <param name="cells">Cells of the surface grid along each axis, one or more.</param>
        /// <param name="capacity">Least number of slots, one or more.</param>
        /// <exception cref="ArgumentOutOfRangeException">A number is too small.</exception>
        /// <exception cref="FluidDeviceException">The device cannot hold them.</exception>
        public void Reserve(Vector3Int cells, int capacity)
        {
            if (cells.x < 1 || cells.y < 1 || cells.z < 1)
            {
                throw new ArgumentOutOfRangeException(nameof(cells), cells,
                    "A surface grid has one cell or more along each axis.");
            }
            if (capacity < 1)
            {
                throw new ArgumentOutOfRangeException(nameof(capacity), capacity,
                    "A sparse surface has one slot or more.");
            }
            if (capacity > DeviceCapacity)
            {
                throw new FluidDeviceException(
                    $"A sparse surface of {capacity} blocks does not fit: a buffer of {SystemInfo.graphicsDeviceName} " +
                    $"holds {DeviceCapacity}. Choose a coarser surface.");
            }

            Vector3Int counts = CountsOver(cells);
            Grow(ref table, "BlockTable", (long)counts.x * counts.y * counts.z, sizeof(uint));
            Grow(ref list, "BlockList", capacity, sizeof(uint));
            Grow(ref samples, "BlockSamples", (long)capacity * SamplesPerBlock, sizeof(float));
            Grow(ref ranges, "BlockRanges", capacity, RangeStride);
            Grow(ref counters, "SurfaceCounters", SurfaceCounters.Slots, sizeof(uint));
            Grow(ref roundArguments, "RoundArguments", 3, sizeof(uint), Arguments);
            Counts = counts;
            Capacity = list.Count;
        }

        /// <summary>Sets the globals of SurfaceBlocks.hlsl; each pass sets its own buffers.</summary>
        public void SetGlobals(CommandBuffer cmd, ComputeKernel kernel)
        {
            CountsValue[0] = Counts.x;
            CountsValue[1] = Counts.y;
            CountsValue[2] = Counts.z;
            kernel.SetInts(cmd, BlockCountsId, CountsValue);
            kernel.SetInt(cmd, BlockCapacityId, Capacity);
        }

        // 64 cells have 66 cubes, 9 blocks.
        private static int CountOver(int cells) => (cells + 2 + CubesPerSide - 1) / CubesPerSide;
    }
}
