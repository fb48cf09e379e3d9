using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// The surface of a liquid as triangles on the GPU, made only where it is: a scalar field in blocks of 8^3 cells
    /// near the surface, marching cubes in those. Nothing waits for the GPU; the buffers grow by what the surface
    /// needed a few frames ago. A surface that does not fit as a whole is not emitted: the last complete one stays, and
    /// a warning says so.
    /// </summary>
    public sealed class SparseSurface : IDisposable
    {
        private readonly SurfacePasses passes;
        private readonly SurfaceBlocks blocks = new SurfaceBlocks();
        private readonly SurfaceTriangles triangles;
        private readonly SurfaceCapacity capacity;
        private readonly NumberReadback readback, sprayReadback;
        private readonly SurfaceWarnings warnings = new SurfaceWarnings();
        private int recordings;

        /// <summary>A surface; most buffers are made when it is first recorded.</summary>
        /// <param name="shaders">Shader set with the kernels of the sparse surface.</param>
        /// <exception cref="FluidDeviceException">The device cannot run a kernel.</exception>
        public SparseSurface(FluidShaderSet shaders)
            : this(shaders, 0, 0)
        {
        }

        internal SparseSurface(FluidShaderSet shaders, int firstBlocks, int firstTriangles)
        {
            if (shaders == null)
            {
                throw new ArgumentNullException(nameof(shaders),
                    "A sparse surface needs a shader set: assign one in the fluid profile.");
            }
            passes = new SurfacePasses(shaders);
            triangles = new SurfaceTriangles();
            capacity = new SurfaceCapacity(firstBlocks, firstTriangles);
            readback = new NumberReadback(SurfaceCounters.Slots, UpdateCounts);
            sprayReadback = new NumberReadback(SprayParticles.ArgumentWords, TakeSpray);
        }

        /// <summary>
        /// Vertices, 16 bytes each: Shaders/Surface/Sparse/SurfaceVertices.hlsl. Ask again after each recording: it may
        /// have grown.
        /// </summary>
        public GraphicsBuffer Vertices => triangles.Vertices;

        /// <summary>
        /// 32-bit indices, three a triangle, clockwise seen from outside the liquid. Ask again after each recording.
        /// </summary>
        public GraphicsBuffer Indices => triangles.Indices;

        /// <summary>One <see cref="GraphicsBuffer.IndirectDrawIndexedArgs"/>: all triangles, one instance.</summary>
        public GraphicsBuffer DrawArguments => triangles.DrawArguments;

        /// <summary>Most triangles; 0: as many as the device holds.</summary>
        public int TriangleBudget
        {
            get => capacity.TriangleBudget;
            set => capacity.TriangleBudget = Math.Max(value, 0);
        }

        /// <summary>What became of the last surface that was read back.</summary>
        public SurfaceStatus Status { get; private set; }

        /// <summary>Bytes of GPU memory.</summary>
        public long GpuBytes => passes.Bytes + blocks.Bytes + triangles.Bytes;

        /// <summary>The particles that left the surface as spray.</summary>
        internal SprayParticles Spray => passes.Spray;

        /// <summary>Particles that were spray in the last surface whose count was read back; 0 where there is no spray.</summary>
        internal long SprayCount { get; private set; }

        /// <summary>Vertices that a particle of the spray is drawn with.</summary>
        internal int SprayVertices { get => passes.SprayVertices; set => passes.SprayVertices = value; }

        internal SurfaceBlocks Blocks => blocks;

        internal SurfaceTriangles Triangles => triangles;

        /// <summary>Records everything from the particles' present positions to the arguments of the draw.</summary>
        /// <param name="cmd">Command buffer to record into.</param>
        /// <param name="solver">The particles; they are sorted into cells first.</param>
        /// <param name="settings">The field.</param>
        /// <param name="grid">The grid, over the solver's domain.</param>
        /// <param name="walls">What becomes of the surface at the domain's walls.</param>
        /// <exception cref="FluidDeviceException">The device cannot hold the first buffers.</exception>
        public void Record(CommandBuffer cmd, FluidSolver solver, in SurfaceFieldSettings settings, SurfaceGrid grid,
            SurfaceWalls walls)
        {
            if (cmd == null) throw new ArgumentNullException(nameof(cmd));
            Require.Known(walls, nameof(walls));
            Reserve(solver, settings, grid);
            RecordReserved(cmd, solver, settings, grid, walls);
        }

        /// <summary>
        /// Makes the buffers large enough by what is known. Those that are drawn stay the same from here to the next call.
        /// </summary>
        /// <exception cref="FluidDeviceException">The device cannot hold the first buffers.</exception>
        internal void Reserve(FluidSolver solver, in SurfaceFieldSettings settings, SurfaceGrid grid)
        {
            Check(solver, settings, grid);
            if (!SystemInfo.supportsAsyncGPUReadback && blocks.Counters != null) readback.ReadNow(blocks.Counters);
            capacity.Reserve(blocks, triangles, grid, settings, solver.ParticleCount, Status);
            passes.Reserve(solver, settings);
        }

        /// <summary>As <see cref="Record"/>, in the buffers as they are.</summary>
        internal void RecordReserved(CommandBuffer cmd, FluidSolver solver, in SurfaceFieldSettings settings,
            SurfaceGrid grid, SurfaceWalls walls)
        {
            recordings++;
            passes.Record(cmd, new SurfaceInput(solver, settings, grid, walls, blocks, recordings), triangles);
            readback.RecordRequest(cmd, blocks.Counters);
            if (settings.HasSpray) sprayReadback.RecordRequest(cmd, Spray.DrawArguments);
            else SprayCount = 0;
        }

        /// <summary>Whether the last recording is known to have become a complete surface.</summary>
        internal bool IsSettled => recordings > 0 && Status.Number == recordings && Status.IsComplete;

        /// <summary>Whether what became of the last recording is still to arrive, some frames later.</summary>
        internal bool IsAwaited => SystemInfo.supportsAsyncGPUReadback && readback.Received < recordings && Status.Number != recordings;

        /// <summary>Surfaces that were recorded.</summary>
        internal int Recordings => recordings;

        /// <summary>
        /// Something that the user must know, e.g. that the surface exceeds its budget; each kind of problem is
        /// reported once.
        /// </summary>
        /// <returns>A sentence with the cure, or null.</returns>
        public string TakeWarning() => warnings.Dequeue();

        /// <summary>
        /// Waits for the GPU and reads what became of the surface that was recorded and executed last; for tools and tests.
        /// </summary>
        /// <returns>The status now.</returns>
        public SurfaceStatus ReadStatus()
        {
            readback.ReadNow(blocks.Counters);
            return Status;
        }

        /// <summary>Waits for the GPU and reads what was recorded and executed last.</summary>
        /// <returns>A mesh in simulation space [m] in which all triangles around a vertex share it. The same liquid
        /// gives the same mesh.</returns>
        /// <exception cref="InvalidOperationException">Nothing was recorded, or the surface did not fit the buffers as
        /// they were.</exception>
        /// <exception cref="FluidDeviceException">The surface is larger than the budget or the device
        /// allows.</exception>
        public SurfaceMesh ReadMesh()
        {
            if (blocks.Counters == null)
            {
                throw new InvalidOperationException(
                    "No surface was recorded: call Record and execute the command buffer first.");
            }
            ReadStatus();
            ThrowIfObstructed();
            if (!Status.IsComplete)
            {
                throw new InvalidOperationException(
                    "The surface did not fit its buffers. Record and execute it again: the buffers have grown by then.");
            }
            return triangles.Read(blocks, Status);
        }

        /// <summary>
        /// Makes the surface now and reads it: records, executes, and repeats with larger buffers until all of it fits.
        /// </summary>
        /// <param name="solver">The particles; they are sorted into cells first.</param>
        /// <param name="settings">The field.</param>
        /// <param name="grid">The grid, over the solver's domain.</param>
        /// <param name="walls">What becomes of the surface at the domain's walls.</param>
        /// <returns>See <see cref="ReadMesh"/>.</returns>
        /// <exception cref="FluidDeviceException">The surface is larger than the budget or the device
        /// allows.</exception>
        public SurfaceMesh Extract(FluidSolver solver, in SurfaceFieldSettings settings, SurfaceGrid grid,
            SurfaceWalls walls)
        {
            do
            {
                using (var cmd = new CommandBuffer { name = "Fluid Surface" })
                {
                    Record(cmd, solver, settings, grid, walls);
                    Graphics.ExecuteCommandBuffer(cmd);
                }
                ReadStatus();
                ThrowIfObstructed();
            }
            while (!Status.IsComplete);
            return triangles.Read(blocks, Status);
        }

        /// <summary>Releases the buffers.</summary>
        public void Dispose()
        {
            readback.Dispose();
            sprayReadback.Dispose();
            passes.Dispose();
            blocks.Dispose();
            triangles.Dispose();
        }

        private static void Check(FluidSolver solver, in SurfaceFieldSettings settings, in SurfaceGrid grid)
        {
            if (solver == null) throw new ArgumentNullException(nameof(solver), "A surface needs a running solver.");
            if (grid.Cells.x < 1) throw new ArgumentException("A sparse surface needs a grid that was made with a size.", nameof(grid));
            if (!settings.IsSet)
            {
                throw new ArgumentException(
                    "A sparse surface needs a field made by SurfaceFieldSettings.For or Thesis.", nameof(settings));
            }
            if (settings.SupportRadius > solver.Settings.SupportRadius)
            {
                throw new ArgumentException(
                    $"The surface field's radius is {settings.SupportRadius} m, but the solver's cells serve " +
                    $"{solver.Settings.SupportRadius} m: make the field's settings from the solver's.", nameof(settings));
            }
        }

        private void ThrowIfObstructed()
        {
            string obstacle = Status.IsComplete ? null : capacity.Obstacle(Status);
            if (obstacle != null) throw new FluidDeviceException(obstacle);
        }

        private void UpdateCounts(uint[] counters)
        {
            Status = new SurfaceStatus(counters);
            warnings.Check(Status, capacity.Obstacle(Status));
        }

        private void TakeSpray(uint[] arguments) => SprayCount = SprayVertices > 0 ? arguments[0] / SprayVertices : 0;
    }
}
