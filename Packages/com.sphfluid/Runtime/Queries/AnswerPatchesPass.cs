using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Answers how much liquid went through rectangles in the world.</summary>
    internal sealed class AnswerPatchesPass : QueryPass
    {
        public const string ShaderName = "AnswerPatches";
        public const int Words = 3;

        private static readonly int PatchesBefore = Id("_PatchesBefore");
        private static readonly int PatchSums = Id("_PatchSums");
        private static readonly int KeysBefore = Id("_KeysBefore");
        private static readonly int PlacesBefore = Id("_PlacesBefore");
        private static readonly int Keys = Id("_Keys");
        private static readonly int Places = Id("_Places");
        private static readonly int ParticleCount = Id("_ParticleCount");
        private static readonly int TableMask = Id("_TableMask");
        private static readonly int TableMaskBefore = Id("_TableMaskBefore");
        private static readonly int ParticleVolume = Id("_ParticleVolume");

        private readonly ComputeKernel clear, flows, answer;
        private readonly PatchSums kept = new PatchSums();

        public AnswerPatchesPass(FluidShaderSet shaders)
            : base(shaders, ShaderName)
        {
            clear = Kernel("ClearPlaces");
            flows = Kernel("CountFlows");
            answer = Kernel();
        }

        /// <inheritdoc/>
        public override long GpuBytes => kept.GpuBytes;

        /// <inheritdoc/>
        public override void Record(CommandBuffer cmd, in QueryTarget target, in QueryBatch asked)
        {
            kept.Reserve(asked.Capacity, target.Solver.ParticleCount, target.Solver.State.Retired);
            Record(cmd, target, asked.Words, kept, asked.Count, asked.First);
        }

        /// <inheritdoc/>
        public override void Dispose() => kept.Dispose();

        /// <param name="cmd">Command buffer to record into, after the neighbour setup.</param>
        /// <param name="target">The liquid and the answers.</param>
        /// <param name="queries">Three words a rectangle: centre [m] and generation, and two edges' directions and half their lengths
        /// [m].</param>
        /// <param name="sums">What goes on from look to look.</param>
        /// <param name="count">Number of rectangles.</param>
        /// <param name="first">Of their answers.</param>
        public void Record(CommandBuffer cmd, in QueryTarget target, GraphicsBuffer queries, PatchSums sums, int count, int first)
        {
            FluidSolver solver = target.Solver;
            using (Sample(cmd))
            {
                clear.SetBuffer(cmd, Keys, sums.Now.Keys);
                clear.SetInt(cmd, TableMask, sums.Now.Length - 1);
                clear.DispatchThreads(cmd, sums.Now.Length);

                QueryBindings.SetSpace(cmd, flows, target);
                QueryBindings.SetQueries(cmd, flows, queries, count);
                SetSums(cmd, flows, sums);
                flows.SetBuffer(cmd, KeysBefore, sums.Before.Keys);
                flows.SetBuffer(cmd, PlacesBefore, sums.Before.Places);
                flows.SetBuffer(cmd, Keys, sums.Now.Keys);
                flows.SetBuffer(cmd, Places, sums.Now.Places);
                flows.SetInt(cmd, TableMask, sums.Now.Length - 1);
                flows.SetInt(cmd, TableMaskBefore, sums.Before.Length - 1);
                flows.SetInt(cmd, ParticleCount, solver.ParticleCount);
                flows.DispatchThreads(cmd, solver.ParticleCount);

                QueryBindings.Set(cmd, answer, target, queries, count, first);
                SetSums(cmd, answer, sums);
                answer.SetFloat(cmd, ParticleVolume, Mathf.Pow(solver.Settings.Spacing, 3f));
                answer.DispatchThreads(cmd, count);
            }
            sums.Swap();
        }

        private static void SetSums(CommandBuffer cmd, ComputeKernel kernel, PatchSums sums)
        {
            kernel.SetBuffer(cmd, PatchesBefore, sums.Patches);
            kernel.SetBuffer(cmd, PatchSums, sums.Sums);
        }
    }
}
