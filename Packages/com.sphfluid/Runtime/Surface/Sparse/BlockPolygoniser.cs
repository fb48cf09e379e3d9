using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Marching cubes in the active blocks of a sparse surface: counts, then emits, so that the mesh is whole or the last one stays.</summary>
    sealed class BlockPolygoniser : IDisposable
    {
        readonly CountBlocksPass count;
        readonly SurfaceDrawArgumentsPass drawArguments;
        readonly EmitBlocksPass emit;
        GraphicsBuffer tables;

        /// <exception cref="FluidDeviceException">The device cannot run a kernel.</exception>
        public BlockPolygoniser(FluidShaderSet shaders)
        {
            count = new CountBlocksPass(shaders);
            drawArguments = new SurfaceDrawArgumentsPass(shaders);
            emit = new EmitBlocksPass(shaders);
            tables = SurfacePolygoniser.CreateTables();
            Mesh = new BlockMesh();
        }

        /// <summary>The triangles.</summary>
        public BlockMesh Mesh { get; }

        public long GpuBytes => GpuBuffers.Size(tables) + Mesh.GpuBytes;

        /// <summary>The blocks of the present round; before the first, the counters of vertices and indices are zero.</summary>
        public void RecordCount(CommandBuffer cmd, SurfaceBlocks blocks, in SurfaceGrid grid, SurfaceWalls walls, float isoValue) =>
            count.Record(cmd, Input(blocks, grid, walls, isoValue));

        /// <summary>All blocks, after they were counted with the same arguments.</summary>
        public void RecordEmit(CommandBuffer cmd, SurfaceBlocks blocks, in SurfaceGrid grid, SurfaceWalls walls, float isoValue)
        {
            drawArguments.Record(cmd, blocks, Mesh);
            emit.Record(cmd, Input(blocks, grid, walls, isoValue), Mesh);
        }

        public void Dispose()
        {
            GpuBuffers.Dispose(ref tables);
            Mesh.Dispose();
        }

        BlockPolygons Input(SurfaceBlocks blocks, in SurfaceGrid grid, SurfaceWalls walls, float isoValue) =>
            new BlockPolygons(blocks, grid, walls, isoValue, tables);
    }
}
