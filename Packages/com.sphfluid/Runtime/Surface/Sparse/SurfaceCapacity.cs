using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// How large the buffers of a sparse surface are. At first by the number of particles; once they are three quarters
    /// full, half as much again as the surface was found to need, up to a limit.
    /// </summary>
    internal sealed class SurfaceCapacity
    {
        // Splashes have 2 to 9 triangles a particle at 1 to 0.5 spacings a cell, large pools less than one: they grow
        // with the square of spacings a cell (surface-quality.md of com.sphfluid.validation).
        private const int SpareTriangles = 65536;
        private const int SplashParticles = 131072;
        private const float SplashTriangles = 2.25f;
        private const float PoolTriangles = 0.8f;

        // Blocks repeat the vertices on their faces: 0.64 vertices a triangle in pools, more in spray.
        private const float VerticesPerTriangle = 0.75f;

        // Pools of 16 thousand to a million particles fill 0.4 to 0.8 of these; spray grows into more.
        private const int SpareBlocks = 256;
        private const float BlocksPerParticle = 0.006f;

        private readonly int firstBlocks;
        private readonly int firstTriangles;

        /// <param name="firstBlocks">Blocks at first; 0: by the number of particles.</param>
        /// <param name="firstTriangles">Triangles at first; 0: by the number of particles.</param>
        public SurfaceCapacity(int firstBlocks, int firstTriangles)
        {
            this.firstBlocks = firstBlocks;
            this.firstTriangles = firstTriangles;
        }

        /// <summary>Most triangles; 0: as many as the device holds.</summary>
        public int TriangleBudget { get; set; }

        private int TriangleLimit => TriangleBudget > 0 ? Math.Min(TriangleBudget, DeviceTriangleLimit) : DeviceTriangleLimit;

        private int VertexLimit => (int)Math.Min(SurfaceTriangles.DeviceVertexLimit, 3L * TriangleLimit);

        private static int DeviceTriangleLimit => SurfaceTriangles.DeviceIndexLimit / 3;

        /// <summary>Grows the buffers by what the last surface needed.</summary>
        public void Reserve(SurfaceBlocks blocks, SurfaceTriangles triangles, in SurfaceGrid grid,
            in SurfaceFieldSettings field, int particles, in SurfaceStatus last)
        {
            float perSpacing = field.Spacing / field.CellSize;
            Vector3Int counts = SurfaceBlocks.CountsOver(grid.Cells);
            int blockLimit = Math.Min(counts.x * counts.y * counts.z, SurfaceBlocks.DeviceCapacity);
            long startBlocks = firstBlocks > 0 ? firstBlocks : StartBlocks(particles, perSpacing);
            blocks.Reserve(grid.Cells, Grown(blocks.Capacity, startBlocks, last.Blocks, blockLimit));

            long start = firstTriangles > 0 ? firstTriangles : StartTriangles(particles, perSpacing);
            long startVertices = (long)Math.Ceiling(VerticesPerTriangle * start);
            int indices = Grown(triangles.IndexCapacity, 3 * start, 3 * last.Triangles, 3 * TriangleLimit);
            int vertices = Grown(triangles.VertexCapacity, startVertices, last.Vertices, VertexLimit);
            triangles.Reserve(vertices, indices);
        }

        /// <summary>
        /// Why a surface that was not complete will not become so by growing, and the cure; null if it will.
        /// </summary>
        public string Obstacle(in SurfaceStatus status)
        {
            if (status.Blocks > SurfaceBlocks.DeviceCapacity)
            {
                return $"The surface lies in {status.Blocks} blocks; a buffer of {SystemInfo.graphicsDeviceName} holds " +
                    $"{SurfaceBlocks.DeviceCapacity}. Choose a lower quality or larger cells.";
            }
            if (TriangleBudget > 0 && status.Triangles > TriangleBudget)
            {
                return $"The surface has {status.Triangles} triangles; its budget is {TriangleBudget}. " +
                    "Raise the triangle budget (0: as many as the device holds), or choose a lower quality or larger " +
                    "cells.";
            }
            if (status.Triangles > TriangleLimit || status.Vertices > VertexLimit)
            {
                return $"The surface has {status.Triangles} triangles; {SystemInfo.graphicsDeviceName} holds " +
                    $"{TriangleLimit} in a buffer. Choose a lower quality or larger cells.";
            }
            return null;
        }

        private static long StartBlocks(int particles, float cellsPerSpacing) =>
            SpareBlocks + (long)(BlocksPerParticle * cellsPerSpacing * cellsPerSpacing * particles);

        private static long StartTriangles(int particles, float cellsPerSpacing)
        {
            int splash = Math.Min(particles, SplashParticles);
            float perCell = SplashTriangles * splash + PoolTriangles * (particles - splash);
            return SpareTriangles + (long)(cellsPerSpacing * cellsPerSpacing * perCell);
        }

        // Before the buffer is full, as a splash grows while the count of an earlier frame is read back. E.g. 80 of 100
        // become 120.
        private static int Grown(int capacity, long start, long used, int limit)
        {
            long grown = 4 * used > 3L * capacity ? used + used / 2 : capacity;
            return (int)Math.Min(Math.Max(grown, start), limit);
        }
    }
}
