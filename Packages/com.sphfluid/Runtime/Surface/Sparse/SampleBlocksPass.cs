using Unity.Profiling;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>The field at the samples of the present round's blocks, a group each (Shaders/Surface/Sparse/SampleBlocks.compute).</summary>
    sealed class SampleBlocksPass
    {
        const string Name = "SampleBlocks";
        const string FilterOnce = "SURFACE_FILTER_ONCE";
        const string FilterTwice = "SURFACE_FILTER_TWICE";
        static readonly ProfilerMarker Marker = ComputeKernel.CreateMarker(Name);
        static readonly int Shapes = Shader.PropertyToID("_SurfaceShapes");
        static readonly int FieldReach = Shader.PropertyToID("_FieldReach");
        static readonly int UnionOffset = Shader.PropertyToID("_UnionOffset");
        static readonly int PeriodSteps = Shader.PropertyToID("_PeriodSteps");

        readonly ComputeKernel kernel;

        public SampleBlocksPass(FluidShaderSet shaders)
        {
            kernel = shaders.Kernel("SampleBlocks", Name);
        }

        public void Record(CommandBuffer cmd, in BlockFieldInput input)
        {
            FluidSolver solver = input.Solver;
            FluidSolverSettings settings = solver.Settings;
            cmd.BeginSample(Marker);
            input.SetGlobals(cmd, kernel);
            GridNeighbours.SetGrid(cmd, kernel, solver.Grid);
            DomainBindings.SetPeriodic(cmd, kernel, settings);
            kernel.SetKeyword(cmd, FilterOnce, input.Field.FilterPasses == 1);
            kernel.SetKeyword(cmd, FilterTwice, input.Field.FilterPasses == 2);
            kernel.SetVector(cmd, PeriodSteps, settings.PeriodLength / input.Field.SupportRadius);
            kernel.SetFloat(cmd, FieldReach, input.Field.KernelReach);
            kernel.SetFloat(cmd, UnionOffset, input.Field.UnionOffset);
            kernel.SetBuffer(cmd, FluidShaderIds.GridIndices, solver.GridIndices);
            kernel.SetBuffer(cmd, SparseShaderIds.SurfaceParticles, input.Particles);
            input.SetShapes(cmd, kernel, Shapes);
            kernel.SetBuffer(cmd, SparseShaderIds.BlockList, input.Blocks.List);
            kernel.SetBuffer(cmd, SparseShaderIds.SurfaceCounters, input.Blocks.Counters);
            kernel.SetBuffer(cmd, SparseShaderIds.BlockSamples, input.Blocks.Samples);
            kernel.DispatchIndirect(cmd, input.Blocks.RoundArguments);
            cmd.EndSample(Marker);
        }
    }
}
