using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// The field at the samples of the present round's blocks, a group each
    /// (Shaders/Surface/Sparse/SampleBlocks.compute).
    /// </summary>
    internal sealed class SampleBlocksPass : ComputePass
    {
        private const string FilterOnce = "SURFACE_FILTER_ONCE";
        private const string FilterTwice = "SURFACE_FILTER_TWICE";

        private static readonly int FieldReach = Id("_FieldReach");
        private static readonly int KernelExtent = Id("_KernelExtent");
        private static readonly int LongestStretch = Id("_LongestStretch");
        private static readonly int UnionOffset = Id("_UnionOffset");
        private static readonly int PeriodSteps = Id("_PeriodSteps");

        private readonly ComputeKernel kernel;

        public SampleBlocksPass(FluidShaderSet shaders)
            : base(shaders, "SampleBlocks")
        {
            kernel = Kernel();
        }

        public void Record(CommandBuffer cmd, in SurfaceInput input, SurfaceParticles particles, SprayParticles spray)
        {
            FluidSolver solver = input.Solver;
            SurfaceFieldSettings field = input.Field;
            using (Sample(cmd))
            {
                input.SetField(cmd, kernel);
                GridNeighbours.SetGrid(cmd, kernel, solver.Grid);
                DomainBindings.SetPeriodic(cmd, kernel, solver.Settings);
                kernel.SetKeyword(cmd, FilterOnce, field.FilterPasses == 1);
                kernel.SetKeyword(cmd, FilterTwice, field.FilterPasses == 2);
                kernel.SetVector(cmd, PeriodSteps, solver.Settings.PeriodLength / field.SupportRadius);
                kernel.SetFloat(cmd, FieldReach, field.KernelReach);
                kernel.SetFloat(cmd, KernelExtent, field.KernelExtent);
                kernel.SetFloat(cmd, UnionOffset, field.UnionOffset);
                kernel.SetBuffer(cmd, FluidShaderIds.GridIndices, solver.GridIndices);
                kernel.Set(cmd, particles.Kernels);
                if (field.IsAnisotropic)
                {
                    kernel.Set(cmd, particles.Shapes);
                }
                else
                {
                    kernel.Set(cmd, spray.Spray);
                    kernel.SetFloat(cmd, LongestStretch, field.LongestShift / field.SupportRadius);
                }
                kernel.Set(cmd, input.Blocks.List);
                kernel.Set(cmd, input.Blocks.Counters);
                kernel.Set(cmd, input.Blocks.Samples);
                kernel.DispatchIndirect(cmd, input.Blocks.RoundArguments);
            }
        }
    }
}
