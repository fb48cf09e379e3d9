using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// Buffers of the Standard method: positions and velocities lie apart as float4 (a velocity's w is the id), once in the order of
    /// the last sort and once as the step left them, in that order but at their new places.
    /// </summary>
    internal sealed class StandardBuffers : IDisposable
    {
        readonly long bytes;
        GraphicsBuffer positions, velocities, newPositions, newVelocities, density, cellCount, cellStart, blockSum, rank, order;

        public StandardBuffers(int particleCount, int cellCount)
        {
            try
            {
                positions = GpuBuffers.Create("Positions", particleCount, 16);
                velocities = GpuBuffers.Create("Velocities", particleCount, 16);
                newPositions = GpuBuffers.Create("NewPositions", particleCount, 16);
                newVelocities = GpuBuffers.Create("NewVelocities", particleCount, 16);
                density = GpuBuffers.Create("DensityAndPressureTerm", particleCount, 8);
                rank = GpuBuffers.Create("Rank", particleCount, 4);
                order = GpuBuffers.Create("Order", particleCount, 4);
                this.cellCount = GpuBuffers.Create("CellCount", cellCount + 1L, 4);
                cellStart = GpuBuffers.Create("CellStart", cellCount + 2L, 4);
                blockSum = GpuBuffers.Create("BlockSum", ScanCellsPass.Groups(cellCount + 1), 4);
                bytes = GpuBuffers.Size(positions, velocities, newPositions, newVelocities, density, this.cellCount, cellStart, blockSum, rank, order);
            }
            catch
            {
                Dispose();
                throw;
            }
        }

        /// <summary>Positions in the order of the last sort [m].</summary>
        public GraphicsBuffer Positions => positions;

        /// <summary>Velocities in the order of the last sort [m/s]; w: the id's bits.</summary>
        public GraphicsBuffer Velocities => velocities;

        /// <summary>Positions after the step [m].</summary>
        public GraphicsBuffer NewPositions => newPositions;

        /// <summary>Velocities after the step [m/s]; w: the id's bits.</summary>
        public GraphicsBuffer NewVelocities => newVelocities;

        /// <summary>ρ [kg/m³] and p/ρ² in the order of the last sort, float2.</summary>
        public GraphicsBuffer Density => density;

        /// <summary>Particles of each cell after the step, and those that left the domain in it.</summary>
        public GraphicsBuffer CellCount => cellCount;

        /// <summary>First particle of each cell, first of those that left the domain, and the end.</summary>
        public GraphicsBuffer CellStart => cellStart;

        /// <summary>Sums of the scan's groups.</summary>
        public GraphicsBuffer BlockSum => blockSum;

        /// <summary>Place of each particle within its cell.</summary>
        public GraphicsBuffer Rank => rank;

        /// <summary>Particles in the order of their cells, as indices, for the stable order.</summary>
        public GraphicsBuffer Order => order;

        /// <summary>What triangles need; null where there never were any.</summary>
        public MeshWallBuffers Walls { get; private set; }

        /// <summary>Makes <see cref="Walls"/>, if they are not there.</summary>
        public void RequireWalls() => Walls ??= new MeshWallBuffers(positions.count);

        /// <summary>Neighbours of the last density pass; of length 0 for a step that searches twice.</summary>
        public NeighbourList List { get; private set; }

        /// <summary>Makes <see cref="List"/>, with entries or without as the settings and the device have it.</summary>
        public void RequireList(in FluidSolverSettings settings)
        {
            int length = settings.NeighbourList ? NeighbourList.LengthFor(settings) : 0;
            if (!NeighbourList.Fits(positions.count, length)) length = 0;
            if (List != null && List.Length > 0 == length > 0) return;
            List?.Dispose();
            List = null;
            List = new NeighbourList(positions.count, length);
        }

        /// <summary>Bytes of all buffers.</summary>
        public long Bytes => bytes + (Walls?.Bytes ?? 0) + (List?.Bytes ?? 0);

        public void Dispose()
        {
            Walls?.Dispose();
            List?.Dispose();
            GpuBuffers.Dispose(ref positions);
            GpuBuffers.Dispose(ref velocities);
            GpuBuffers.Dispose(ref newPositions);
            GpuBuffers.Dispose(ref newVelocities);
            GpuBuffers.Dispose(ref density);
            GpuBuffers.Dispose(ref cellCount);
            GpuBuffers.Dispose(ref cellStart);
            GpuBuffers.Dispose(ref blockSum);
            GpuBuffers.Dispose(ref rank);
            GpuBuffers.Dispose(ref order);
        }
    }
}
