using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// The field of a liquid's surface in the blocks near it: clears the blocks, marks those near the surface by the particles, lists them and samples
    /// the field there. Nothing is read back.
    /// </summary>
    public sealed class BlockField : IDisposable
    {
        // float4 a particle, Shaders/Surface/Sparse/SurfaceParticles.hlsl.
        const int ParticleStride = 4 * sizeof(float);
        const int ShapeStride = 6 * sizeof(float);

        readonly ClearSurfaceBlocksPass clear;
        readonly PrepareSurfaceParticlesPass prepare;
        readonly ListSurfaceBlocksPass list;
        readonly BeginSurfaceRoundPass beginRound;
        readonly SampleBlocksPass sample;
        GraphicsBuffer particles, shapes;

        /// <summary>A field.</summary>
        /// <param name="shaders">Shader set with the kernels of the sparse surface.</param>
        /// <exception cref="FluidDeviceException">The device cannot run a kernel.</exception>
        public BlockField(FluidShaderSet shaders)
        {
            if (shaders == null)
                throw new ArgumentNullException(nameof(shaders), "A sparse surface needs a shader set: assign one in the fluid profile.");
            clear = new ClearSurfaceBlocksPass(shaders);
            prepare = new PrepareSurfaceParticlesPass(shaders);
            list = new ListSurfaceBlocksPass(shaders);
            beginRound = new BeginSurfaceRoundPass(shaders);
            sample = new SampleBlocksPass(shaders);
        }

        /// <summary>Bytes of GPU memory besides the blocks'.</summary>
        public long GpuBytes => (particles == null ? 0 : GpuBuffers.Size(particles)) + (shapes == null ? 0 : GpuBuffers.Size(shapes));

        /// <summary>
        /// Records everything from the particles' present positions to the samples of the blocks that they mark. Where more blocks are
        /// marked than there are slots, none is sampled, and the counters say how many are wanted.
        /// </summary>
        /// <param name="cmd">Command buffer to record into.</param>
        /// <param name="solver">The particles; they are sorted into cells first.</param>
        /// <param name="field">The field.</param>
        /// <param name="grid">The grid, over the solver's domain.</param>
        /// <param name="wallsClosed">Whether the surface runs along the domain's walls.</param>
        /// <param name="blocks">The blocks, reserved for the grid.</param>
        public void Record(CommandBuffer cmd, FluidSolver solver, in SurfaceFieldSettings field, SurfaceGrid grid, bool wallsClosed, SurfaceBlocks blocks)
        {
            BlockFieldInput input = Input(cmd, solver, field, grid, wallsClosed, blocks);
            solver.RecordNeighbourSetup(cmd);
            clear.Record(cmd, blocks);
            prepare.Record(cmd, input);
            list.Record(cmd, blocks);
            RecordRound(cmd, input, false);
        }

        /// <summary>Records the samples of the blocks that were listed since; with the same arguments as <see cref="Record"/>.</summary>
        public void RecordLate(CommandBuffer cmd, FluidSolver solver, in SurfaceFieldSettings field, SurfaceGrid grid, bool wallsClosed, SurfaceBlocks blocks) =>
            RecordRound(cmd, Input(cmd, solver, field, grid, wallsClosed, blocks), true);

        /// <summary>Records the samples of the blocks that are listed, whoever did it; the particles are as <see cref="Record"/> left them.</summary>
        internal void RecordListed(CommandBuffer cmd, FluidSolver solver, in SurfaceFieldSettings field, SurfaceGrid grid, bool wallsClosed, SurfaceBlocks blocks) =>
            RecordRound(cmd, Input(cmd, solver, field, grid, wallsClosed, blocks), false);

        /// <summary>Releases the buffers.</summary>
        public void Dispose()
        {
            GpuBuffers.Dispose(ref particles);
            GpuBuffers.Dispose(ref shapes);
        }

        void RecordRound(CommandBuffer cmd, in BlockFieldInput input, bool late)
        {
            beginRound.Record(cmd, input.Blocks, late);
            sample.Record(cmd, input);
        }

        BlockFieldInput Input(CommandBuffer cmd, FluidSolver solver, in SurfaceFieldSettings field, SurfaceGrid grid, bool wallsClosed, SurfaceBlocks blocks)
        {
            if (cmd == null)
                throw new ArgumentNullException(nameof(cmd));
            if (solver == null)
                throw new ArgumentNullException(nameof(solver), "A surface field needs a running solver.");
            if (!field.IsSet)
                throw new ArgumentException("A surface field needs settings made by SurfaceFieldSettings.For or Thesis.", nameof(field));
            if (field.SupportRadius > solver.Settings.SupportRadius)
            {
                throw new ArgumentException($"The surface field's radius is {field.SupportRadius} m, but the solver's cells serve {solver.Settings.SupportRadius} m: " +
                    "make the field's settings from the solver's.", nameof(field));
            }
            if (blocks == null || blocks.Counts != SurfaceBlocks.CountsOver(grid.Cells))
                throw new ArgumentException("The blocks are not reserved for this grid: call SurfaceBlocks.Reserve.", nameof(blocks));
            GpuBuffers.Reserve(ref particles, "SurfaceParticles", solver.ParticleCount, ParticleStride);
            if (field.IsAnisotropic)
                GpuBuffers.Reserve(ref shapes, "SurfaceShapes", solver.ParticleCount, ShapeStride);
            return new BlockFieldInput(solver, field, grid, wallsClosed, blocks, particles, field.IsAnisotropic ? shapes : null);
        }
    }
}
