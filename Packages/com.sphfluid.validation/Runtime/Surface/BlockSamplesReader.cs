using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Reads the samples of a sparse surface's blocks back as a dense field.</summary>
    static class BlockSamplesReader
    {
        /// <summary>Field values at the vertices of the grid, x fastest; not a number where no block holds a sample.</summary>
        /// <param name="blocks">Sampled blocks of the grid. Waits for the GPU.</param>
        /// <param name="grid">The grid.</param>
        public static float[] Read(SurfaceBlocks blocks, SurfaceGrid grid)
        {
            var values = new float[grid.VertexCount];
            for (int i = 0; i < values.Length; i++)
                values[i] = float.NaN;
            var slots = new uint[blocks.BlockCount];
            blocks.Table.GetData(slots);
            var samples = new float[blocks.Capacity * SurfaceBlocks.SamplesPerBlock];
            blocks.Samples.GetData(samples);
            for (int block = 0; block < slots.Length; block++)
            {
                // Marked blocks that were not listed hold nothing.
                if (slots[block] == 0 || slots[block] > blocks.Capacity)
                    continue;
                var number = new Vector3Int(block % blocks.Counts.x, block / blocks.Counts.x % blocks.Counts.y, block / (blocks.Counts.x * blocks.Counts.y));
                Copy(samples, (int)(slots[block] - 1) * SurfaceBlocks.SamplesPerBlock, number * SurfaceBlocks.CubesPerSide - Vector3Int.one, grid, values);
            }
            return values;
        }

        static void Copy(float[] samples, int first, Vector3Int origin, SurfaceGrid grid, float[] values)
        {
            const int side = SurfaceBlocks.SamplesPerSide;
            for (int i = 0; i < SurfaceBlocks.SamplesPerBlock; i++)
            {
                Vector3Int v = origin + new Vector3Int(i % side, i / side % side, i / (side * side));
                if (Vector3Int.Max(Vector3Int.zero, Vector3Int.Min(grid.Cells, v)) == v)
                    values[grid.Index(v.x, v.y, v.z)] = samples[first + i];
            }
        }
    }
}
