using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>What the passes of a sparse surface work on.</summary>
    internal readonly struct SurfaceInput
    {
        private const string Anisotropic = "SURFACE_ANISOTROPIC";

        private static readonly int FieldStep = Shader.PropertyToID("_FieldStep");
        private static readonly int FieldRadius = Shader.PropertyToID("_FieldRadius");
        private static readonly int WallCompletion = Shader.PropertyToID("_WallCompletion");

        public SurfaceInput(FluidSolver solver, in SurfaceFieldSettings field, in SurfaceGrid grid, SurfaceWalls walls,
            SurfaceBlocks blocks, int number = 0)
        {
            Solver = solver;
            Field = field;
            Grid = grid;
            Walls = walls;
            Blocks = blocks;
            Number = number;
        }

        /// <summary>The particles; triangles are made without.</summary>
        public FluidSolver Solver { get; }

        public SurfaceFieldSettings Field { get; }

        /// <summary>The grid, over the solver's domain.</summary>
        public SurfaceGrid Grid { get; }

        public SurfaceWalls Walls { get; }

        /// <summary>The blocks, reserved for the grid.</summary>
        public SurfaceBlocks Blocks { get; }

        /// <summary>Of the recording, for the counters.</summary>
        public int Number { get; }

        /// <summary>Grid, blocks and scale of the field: for kernels that read or write particles.</summary>
        public void SetField(CommandBuffer cmd, ComputeKernel kernel)
        {
            kernel.SetGrid(cmd, Grid);
            Blocks.SetGlobals(cmd, kernel);
            kernel.SetVector(cmd, FieldStep, Grid.CellSize / Field.SupportRadius);
            kernel.SetFloat(cmd, FieldRadius, Field.SupportRadius);
            kernel.SetBool(cmd, WallCompletion, Field.WallCompletion);
            kernel.SetKeyword(cmd, Anisotropic, Field.IsAnisotropic);
        }

        /// <summary>Grid, blocks with their samples and ranges, and tables: for kernels that make triangles.</summary>
        public void SetPolygons(CommandBuffer cmd, ComputeKernel kernel, FluidBuffer tables)
        {
            kernel.SetGrid(cmd, Grid, Walls);
            kernel.SetIsoValue(cmd, Field.IsoValue);
            Blocks.SetGlobals(cmd, kernel);
            kernel.Set(cmd, Blocks.Table);
            kernel.Set(cmd, Blocks.List);
            kernel.Set(cmd, Blocks.Samples);
            kernel.Set(cmd, Blocks.Ranges);
            kernel.Set(cmd, Blocks.Counters);
            kernel.Set(cmd, tables);
        }
    }

    /// <summary>
    /// From particles to triangles: prepare the particles and mark the blocks near the surface, list those blocks, sample
    /// the field in them, count their triangles, emit. Nothing is read back. <see cref="SurfaceDrawing"/> draws the
    /// triangles, <see cref="FilledMesh"/> copies them into a mesh.
    /// </summary>
    internal sealed class SurfacePasses : IDisposable
    {
        private readonly ClearSurfaceBlocksPass clear;
        private readonly PrepareSurfaceParticlesPass prepare;
        private readonly ListSprayPass listSpray;
        private readonly ListSurfaceBlocksPass list;
        private readonly SampleBlocksPass sample;
        private readonly CountBlocksPass count;
        private readonly SurfaceDrawArgumentsPass drawArguments;
        private readonly EmitBlocksPass emit;
        private readonly FluidBuffer tables;

        /// <exception cref="FluidDeviceException">The device cannot run a kernel.</exception>
        public SurfacePasses(FluidShaderSet shaders)
        {
            clear = new ClearSurfaceBlocksPass(shaders);
            prepare = new PrepareSurfaceParticlesPass(shaders);
            listSpray = new ListSprayPass(shaders);
            list = new ListSurfaceBlocksPass(shaders);
            sample = new SampleBlocksPass(shaders);
            count = new CountBlocksPass(shaders);
            drawArguments = new SurfaceDrawArgumentsPass(shaders);
            emit = new EmitBlocksPass(shaders);
            tables = MarchingCubesTables.CreateBuffer();
        }

        /// <summary>The particles as the field reads them.</summary>
        public SurfaceParticles Particles { get; } = new SurfaceParticles();

        /// <summary>The particles that left the surface, where the field lets them.</summary>
        public SprayParticles Spray { get; } = new SprayParticles();

        /// <summary>Vertices that a particle of the spray is drawn with.</summary>
        public int SprayVertices { get; set; }

        /// <summary>Bytes of GPU memory besides the blocks' and the triangles'.</summary>
        public long Bytes => GpuBuffers.Size(tables) + Particles.Bytes + Spray.Bytes;

        /// <summary>
        /// Records everything from the particles' present positions to the arguments of the draw. Where more blocks are
        /// marked than there are slots, none is sampled; where the triangles do not fit, none is emitted. The counters
        /// say how many there are.
        /// </summary>
        public void Record(CommandBuffer cmd, in SurfaceInput input, SurfaceTriangles triangles)
        {
            RecordField(cmd, input);
            RecordCount(cmd, input);
            RecordLateSamples(cmd, input);
            RecordCount(cmd, input);
            RecordTriangles(cmd, input, triangles);
        }

        /// <summary>Makes the buffers for the particles large enough.</summary>
        /// <exception cref="FluidDeviceException">The device has too little memory.</exception>
        public void Reserve(FluidSolver solver, in SurfaceFieldSettings field)
        {
            Particles.Reserve(solver.ParticleCount, field.IsAnisotropic);
            Spray.Reserve(field.HasSpray ? solver.ParticleCount : 1);
        }

        /// <summary>From the particles to the samples of the blocks that they mark.</summary>
        public void RecordField(CommandBuffer cmd, in SurfaceInput input)
        {
            Reserve(input.Solver, input.Field);
            input.Solver.RecordNeighbourSetup(cmd);
            clear.Record(cmd, input.Blocks, input.Number);
            prepare.Record(cmd, input, Particles, Spray);
            if (input.Field.HasSpray) listSpray.Record(cmd, input.Solver, Spray, SprayVertices);
            list.Record(cmd, input.Blocks);
            RecordSamples(cmd, input);
        }

        /// <summary>
        /// Samples of the blocks that are listed; the particles are as <see cref="RecordField"/> left them.
        /// </summary>
        public void RecordSamples(CommandBuffer cmd, in SurfaceInput input) => RecordRound(cmd, input, false);

        /// <summary>
        /// Samples of the blocks that <see cref="RecordCount"/> listed: those that the surface reaches though no
        /// particle marked them.
        /// </summary>
        public void RecordLateSamples(CommandBuffer cmd, in SurfaceInput input) => RecordRound(cmd, input, true);

        /// <summary>Vertices and indices of the blocks that were sampled last.</summary>
        public void RecordCount(CommandBuffer cmd, in SurfaceInput input) => count.Record(cmd, input, tables);

        /// <summary>The triangles of all blocks, after they were counted with the same input.</summary>
        public void RecordTriangles(CommandBuffer cmd, in SurfaceInput input, SurfaceTriangles triangles)
        {
            drawArguments.Record(cmd, input.Blocks, triangles);
            emit.Record(cmd, input, tables, triangles);
        }

        public void Dispose()
        {
            tables.Dispose();
            Particles.Dispose();
            Spray.Dispose();
        }

        private void RecordRound(CommandBuffer cmd, in SurfaceInput input, bool late)
        {
            list.RecordRound(cmd, input.Blocks, late);
            sample.Record(cmd, input, Particles, Spray);
        }
    }
}
