using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>What the passes of <see cref="BlockField"/> work on.</summary>
    readonly struct BlockFieldInput
    {
        const string Anisotropic = "SURFACE_ANISOTROPIC";

        static readonly int FieldStep = Shader.PropertyToID("_FieldStep");
        static readonly int FieldRadius = Shader.PropertyToID("_FieldRadius");
        static readonly int WallCompletion = Shader.PropertyToID("_WallCompletion");

        public BlockFieldInput(FluidSolver solver, in SurfaceFieldSettings field, SurfaceGrid grid, bool wallsClosed, SurfaceBlocks blocks,
            GraphicsBuffer particles, GraphicsBuffer shapes)
        {
            Solver = solver;
            Field = field;
            Grid = grid;
            WallsClosed = wallsClosed;
            Blocks = blocks;
            Particles = particles;
            Shapes = shapes;
        }

        public FluidSolver Solver { get; }

        public SurfaceFieldSettings Field { get; }

        public SurfaceGrid Grid { get; }

        /// <summary>Whether the surface runs along walls.</summary>
        public bool WallsClosed { get; }

        public SurfaceBlocks Blocks { get; }

        /// <summary>float4 a particle, Shaders/Surface/Sparse/SurfaceParticles.hlsl.</summary>
        public GraphicsBuffer Particles { get; }

        /// <summary>KernelShape a particle; null where all kernels are round.</summary>
        public GraphicsBuffer Shapes { get; }

        /// <summary>The grid, the blocks, and how the particles are written.</summary>
        public void SetGlobals(CommandBuffer cmd, ComputeKernel kernel)
        {
            kernel.SetGrid(cmd, Grid);
            Blocks.SetGlobals(cmd, kernel);
            kernel.SetVector(cmd, FieldStep, Grid.CellSize / Field.SupportRadius);
            kernel.SetFloat(cmd, FieldRadius, Field.SupportRadius);
            kernel.SetBool(cmd, WallCompletion, Field.WallCompletion);
        }

        /// <summary>The keyword of kernels that know stretched kernels, and the shapes where there are any.</summary>
        public void SetShapes(CommandBuffer cmd, ComputeKernel kernel, int id)
        {
            kernel.SetKeyword(cmd, Anisotropic, Field.IsAnisotropic);
            if (Field.IsAnisotropic)
                kernel.SetBuffer(cmd, id, Shapes);
        }
    }
}
