using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// The scalar field of the surface on the GPU: a density factor at each vertex of a <see cref="SurfaceGrid"/>, 1 in
    /// liquid at rest and 0 where no particle is near. The surface is where it equals the iso value.
    /// </summary>
    public sealed class SurfaceField : IDisposable
    {
        // Three grid edges start at each vertex; their names are 32 bits long.
        private const double MostNamedVertices = uint.MaxValue / 3;

        private readonly ResetMCGridPass resetGrid;
        private readonly SetMCGridDensityFactorsPass setDensityFactors;
        private readonly FluidBuffer values;

        /// <summary>A field on a grid.</summary>
        /// <param name="shaders">Shader set with the surface field's kernels.</param>
        /// <param name="grid">The grid.</param>
        /// <exception cref="ArgumentException">The grid has no size, or more edges than 32 bits can name.</exception>
        /// <exception cref="FluidDeviceException">The device cannot hold the grid or run the kernels.</exception>
        public SurfaceField(FluidShaderSet shaders, SurfaceGrid grid)
        {
            if (shaders == null)
            {
                throw new ArgumentNullException(nameof(shaders),
                    "A surface field needs a shader set: assign one in the fluid profile.");
            }
            if (grid.Cells.x < 1) throw new ArgumentException("A surface field needs a grid that was made with a size.", nameof(grid));
            Vector3 sides = grid.Cells + 3 * Vector3Int.one; // with two layers of the ring
            if ((double)sides.x * sides.y * sides.z > MostNamedVertices)
            {
                throw new ArgumentException(
                    $"A surface field of {grid.Cells.x} x {grid.Cells.y} x {grid.Cells.z} cells has more edges than 32 bits can name. " +
                    "Choose larger cells or a smaller domain.", nameof(grid));
            }
            Grid = grid;
            if (GpuBytes > SystemInfo.maxGraphicsBufferSize)
            {
                throw new FluidDeviceException(
                    $"A surface grid of {grid.Cells.x} x {grid.Cells.y} x {grid.Cells.z} cells needs a buffer of " +
                    $"{GpuBytes / 1048576.0:F0} MiB; " +
                    $"{SystemInfo.graphicsDeviceName} allows {SystemInfo.maxGraphicsBufferSize / 1048576.0:F0} MiB. Choose a smaller " +
                    "grid size.");
            }
            resetGrid = new ResetMCGridPass(shaders);
            setDensityFactors = new SetMCGridDensityFactorsPass(shaders);
            values = new FluidBuffer("MCGrid", grid.VertexCount, sizeof(float));
        }

        /// <summary>The grid.</summary>
        public SurfaceGrid Grid { get; }

        /// <summary>Density factors, one float a grid vertex, x fastest.</summary>
        public GraphicsBuffer Values => values;

        internal FluidBuffer Buffer => values;

        /// <summary>Bytes of GPU memory that the field holds.</summary>
        public long GpuBytes => (long)Grid.VertexCount * sizeof(float);

        /// <summary>
        /// Divides the density near a wall of the domain by the part of the kernel that lies inside, as if the liquid
        /// went on behind the wall, so that the surface is level at walls. Off: as the thesis prints it; the surface
        /// then falls away from the walls.
        /// </summary>
        public bool WallCompletion { get; set; } = true;

        /// <summary>Records everything from the particles' present positions to the finished field.</summary>
        /// <param name="cmd">Command buffer to record into.</param>
        /// <param name="solver">The particles; they are sorted into cells first, so that the ranges of the cells
        /// fit.</param>
        public void Record(CommandBuffer cmd, FluidSolver solver)
        {
            if (cmd == null) throw new ArgumentNullException(nameof(cmd));
            if (solver == null) throw new ArgumentNullException(nameof(solver), "A surface field needs a running solver.");
            solver.RecordNeighbourSetup(cmd);
            resetGrid.Record(cmd, this);
            setDensityFactors.Record(cmd, this, solver);
        }

        /// <summary>Releases the buffer.</summary>
        public void Dispose() => values.Dispose();
    }
}
