using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Rebuilds the list of whitewater: what is left of it, then what the liquid adds.</summary>
    internal sealed class WhitewaterListPass : ComputePass
    {
        private const int ScanThreads = 256;

        private static readonly int Particles = Id("_Particles");
        private static readonly int Capacity = Id("_Capacity");
        private static readonly int SurvivorGroups = Id("_SurvivorGroups");
        private static readonly int GroupTotal = Id("_GroupTotal");
        private static readonly int VerticesPerPiece = Id("_VerticesPerPiece");
        private static readonly int Step = Id("_Step");
        private static readonly int Spacing = Id("_Spacing");
        private static readonly int Duration = Id("_Duration");
        private static readonly int FoamLife = Id("_FoamLife");

        private readonly ComputeKernel survivors, births, scan, list, bear;

        public WhitewaterListPass(FluidShaderSet shaders)
            : base(shaders, "WhitewaterList")
        {
            survivors = Kernel("CountSurvivors");
            births = Kernel("CountBirths");
            scan = Kernel("ScanWhitewater");
            list = Kernel();
            bear = Kernel("BearWhitewater");
        }

        /// <summary>After the other passes with the same buffers; <see cref="WhitewaterBuffers.Next"/> is written.</summary>
        /// <param name="cmd">Command buffer to record into.</param>
        /// <param name="solver">The liquid.</param>
        /// <param name="buffers">The pieces.</param>
        /// <param name="step">Steps of the liquid so far, the seed of chance.</param>
        /// <param name="foamLife">How long foam lies on still water, at most [s].</param>
        /// <param name="duration">Length of the frame [s].</param>
        public void Record(CommandBuffer cmd, FluidSolver solver, WhitewaterBuffers buffers, int step, float foamLife, float duration)
        {
            using (Sample(cmd))
            {
                SetSurvivors(cmd, survivors, buffers, solver);
                survivors.DispatchThreads(cmd, buffers.Capacity);

                SetBirths(cmd, births, buffers, solver, step);
                births.DispatchThreads(cmd, solver.ParticleCount);

                SetCommon(cmd, scan, buffers, solver);
                scan.SetInt(cmd, VerticesPerPiece, WhitewaterBuffers.VerticesPerPiece);
                scan.Set(cmd, buffers.DrawArguments);
                scan.DispatchThreads(cmd, ScanThreads);

                SetSurvivors(cmd, list, buffers, solver);
                list.SetOut(cmd, buffers.Next);
                list.DispatchThreads(cmd, buffers.Capacity);

                SetBirths(cmd, bear, buffers, solver, step);
                DomainBindings.SetFaces(cmd, bear, solver.Settings);
                bear.Set(cmd, buffers.Normals);
                bear.SetOut(cmd, buffers.Next);
                bear.SetFloat(cmd, Spacing, solver.Settings.Spacing);
                bear.SetFloat(cmd, Duration, duration);
                bear.SetFloat(cmd, FoamLife, foamLife);
                bear.DispatchThreads(cmd, solver.ParticleCount);
            }
        }

        private static void SetCommon(CommandBuffer cmd, ComputeKernel kernel, WhitewaterBuffers buffers, FluidSolver solver)
        {
            kernel.Set(cmd, buffers.Groups);
            kernel.Set(cmd, buffers.State);
            kernel.SetInt(cmd, Capacity, buffers.Capacity);
            kernel.SetInt(cmd, SurvivorGroups, buffers.SurvivorGroups);
            kernel.SetInt(cmd, GroupTotal, buffers.GroupTotal(solver.ParticleCount));
        }

        private static void SetSurvivors(CommandBuffer cmd, ComputeKernel kernel, WhitewaterBuffers buffers, FluidSolver solver)
        {
            SetCommon(cmd, kernel, buffers, solver);
            kernel.Set(cmd, buffers.Present);
        }

        private static void SetBirths(CommandBuffer cmd, ComputeKernel kernel, WhitewaterBuffers buffers, FluidSolver solver, int step)
        {
            SetCommon(cmd, kernel, buffers, solver);
            kernel.SetBuffer(cmd, Particles, solver.Particles);
            kernel.Set(cmd, buffers.Potentials);
            kernel.SetInt(cmd, FluidShaderIds.ParticleCount, solver.ParticleCount);
            kernel.SetInt(cmd, Step, step);
        }
    }
}
