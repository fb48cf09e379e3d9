using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid.Laboratory
{
    /// <summary>For measurements only: the sparse surface's field as numbers, for polygonisers that it is compared with.</summary>
    public sealed class SparseFieldReader : IDisposable
    {
        private readonly SurfacePasses passes;
        private readonly SurfaceBlocks blocks = new SurfaceBlocks();

        /// <summary>For measurements: prepares the kernels.</summary>
        /// <param name="shaders">The shaders.</param>
        /// <exception cref="FluidDeviceException">The device cannot run a kernel.</exception>
        public SparseFieldReader(FluidShaderSet shaders) => passes = new SurfacePasses(shaders);

        /// <summary>For measurements: blocks that a grid is cut into, of which the sparse surface holds those near the surface.</summary>
        /// <param name="grid">The grid.</param>
        /// <returns>Their number.</returns>
        public static int BlocksOf(SurfaceGrid grid)
        {
            Vector3Int counts = SurfaceBlocks.CountsOver(grid.Cells);
            return counts.x * counts.y * counts.z;
        }

        /// <summary>For measurements: samples the field where the particles mark blocks, and waits for the GPU.</summary>
        /// <param name="solver">The particles.</param>
        /// <param name="settings">The field.</param>
        /// <param name="grid">The grid.</param>
        /// <returns>A value for each vertex of the grid, x fastest; not a number where no block was sampled.</returns>
        /// <exception cref="FluidDeviceException">The device cannot hold all blocks of the grid.</exception>
        public float[] Read(FluidSolver solver, in SurfaceFieldSettings settings, SurfaceGrid grid)
        {
            blocks.Reserve(grid.Cells, BlocksOf(grid));
            using (var cmd = new CommandBuffer { name = "Sparse Field" })
            {
                passes.RecordField(cmd, new SurfaceInput(solver, settings, grid, SurfaceWalls.Closed, blocks));
                Graphics.ExecuteCommandBuffer(cmd);
            }

            return Gather(grid);
        }

        /// <summary>Releases the GPU memory.</summary>
        public void Dispose()
        {
            passes.Dispose();
            blocks.Dispose();
        }

        private float[] Gather(SurfaceGrid grid)
        {
            var values = new float[grid.VertexCount];
            for (int i = 0; i < values.Length; i++) values[i] = float.NaN;
            var slots = new uint[blocks.BlockCount];
            blocks.Table.GetData(slots);
            var samples = new float[blocks.Capacity * SurfaceBlocks.SamplesPerBlock];
            blocks.Samples.GetData(samples);
            for (int block = 0; block < slots.Length; block++)
            {
                // Marked blocks that were not listed hold nothing.
                if (slots[block] == 0 || slots[block] > blocks.Capacity) continue;
                Vector3Int counts = blocks.Counts;
                var number = new Vector3Int(block % counts.x, block / counts.x % counts.y, block / (counts.x * counts.y));
                int first = (int)(slots[block] - 1) * SurfaceBlocks.SamplesPerBlock;
                Copy(samples, first, number * SurfaceBlocks.CubesPerSide - Vector3Int.one, grid, values);
            }

            return values;
        }

        private static void Copy(float[] samples, int first, Vector3Int origin, SurfaceGrid grid, float[] values)
        {
            const int side = SurfaceBlocks.SamplesPerSide;
            for (int i = 0; i < SurfaceBlocks.SamplesPerBlock; i++)
            {
                Vector3Int v = origin + new Vector3Int(i % side, i / side % side, i / (side * side));
                if (Vector3Int.Max(Vector3Int.zero, Vector3Int.Min(grid.Cells, v)) == v)
                {
                    values[grid.Index(v.x, v.y, v.z)] = samples[first + i];
                }
            }
        }
    }
}
