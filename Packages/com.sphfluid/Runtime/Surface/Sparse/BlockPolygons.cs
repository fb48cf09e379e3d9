using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>What the passes of <see cref="BlockPolygoniser"/> work on.</summary>
    readonly struct BlockPolygons
    {
        public BlockPolygons(SurfaceBlocks blocks, in SurfaceGrid grid, SurfaceWalls walls, float isoValue, GraphicsBuffer tables)
        {
            Blocks = blocks;
            Grid = grid;
            Walls = walls;
            IsoValue = isoValue;
            Tables = tables;
        }

        public SurfaceBlocks Blocks { get; }

        public SurfaceGrid Grid { get; }

        public SurfaceWalls Walls { get; }

        /// <summary>Field value on the surface.</summary>
        public float IsoValue { get; }

        /// <summary>Tables of marching cubes.</summary>
        public GraphicsBuffer Tables { get; }

        /// <summary>The grid, the blocks with their samples and ranges, the tables.</summary>
        public void SetGlobals(CommandBuffer cmd, ComputeKernel kernel)
        {
            kernel.SetGrid(cmd, Grid, Walls);
            kernel.SetIsoValue(cmd, IsoValue);
            Blocks.SetGlobals(cmd, kernel);
            kernel.SetBuffer(cmd, SparseShaderIds.BlockTable, Blocks.Table);
            kernel.SetBuffer(cmd, SparseShaderIds.BlockList, Blocks.List);
            kernel.SetBuffer(cmd, SparseShaderIds.BlockSamples, Blocks.Samples);
            kernel.SetBuffer(cmd, SparseShaderIds.BlockRanges, Blocks.Ranges);
            kernel.SetBuffer(cmd, SparseShaderIds.SurfaceCounters, Blocks.Counters);
            kernel.SetBuffer(cmd, SurfaceShaderIds.MCTables, Tables);
        }
    }
}
