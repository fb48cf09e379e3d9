using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Answers how much liquid boxes in the world hold.</summary>
    internal sealed class AnswerBoxesPass : QueryPass
    {
        public const string ShaderName = "AnswerBoxes";
        public const int Words = 4;

        /// <summary>Numbers of the sums a box.</summary>
        public const int Sums = 3;

        private const int BoxesAtOnce = 16;

        private static readonly int BoxSums = Id("_BoxSums");
        private static readonly int ParticleCount = Id("_ParticleCount");
        private static readonly int FirstBox = Id("_FirstBox");
        private static readonly int ParticleSide = Id("_ParticleSide");
        private static readonly int RestShare = Id("_RestShare");

        private readonly ComputeKernel sum, answer;
        private GraphicsBuffer kept;

        public AnswerBoxesPass(FluidShaderSet shaders)
            : base(shaders, ShaderName)
        {
            sum = Kernel("SumBoxes");
            answer = Kernel();
        }

        /// <inheritdoc/>
        public override long GpuBytes => GpuBuffers.Size(kept);

        /// <inheritdoc/>
        public override void Record(CommandBuffer cmd, in QueryTarget target, in QueryBatch asked)
        {
            Reserve(Sums * asked.Capacity, target.Solver.State.Retired);
            Record(cmd, target, asked.Words, kept, asked.Count, asked.First);
        }

        /// <inheritdoc/>
        public override void Dispose() => GpuBuffers.Dispose(ref kept);

        /// <param name="cmd">Command buffer to record into, after the neighbour setup.</param>
        /// <param name="target">The liquid and the answers.</param>
        /// <param name="queries">Four words a box: centre [m] and generation, and three axes of length 1 and half the length along each
        /// [m].</param>
        /// <param name="sums">Numbers that are zero, <see cref="Sums"/> a box; they are again afterwards.</param>
        /// <param name="count">Number of boxes.</param>
        /// <param name="first">Of their answers.</param>
        public void Record(CommandBuffer cmd, in QueryTarget target, GraphicsBuffer queries, GraphicsBuffer sums, int count, int first)
        {
            float side = target.Solver.Settings.Spacing;
            using (Sample(cmd))
            {
                for (int box = 0; box < count; box += BoxesAtOnce)
                {
                    Set(cmd, sum, target, queries, sums, count, side);
                    sum.SetInt(cmd, ParticleCount, target.Solver.ParticleCount);
                    sum.SetInt(cmd, FirstBox, box);
                    sum.DispatchThreads(cmd, target.Solver.ParticleCount);
                }
                Set(cmd, answer, target, queries, sums, count, side);
                QueryBindings.SetResults(cmd, answer, target, first);
                FluidSolverSettings settings = target.Solver.Settings;
                answer.SetFloat(cmd, RestShare,
                    (float)(settings.ParticleMass / (settings.RestDensity * System.Math.Pow(settings.Spacing, 3.0))));
                answer.DispatchThreads(cmd, count);
            }
        }

        private void Reserve(int sums, RetiredBuffers retired)
        {
            if (kept != null && kept.count >= sums) return;
            if (kept != null) retired.Add(kept);
            kept = GpuBuffers.Create("Fluid Box Sums", sums, sizeof(uint));
            kept.SetData(new uint[sums]);
        }

        private static void Set(CommandBuffer cmd, ComputeKernel kernel, in QueryTarget target, GraphicsBuffer queries, GraphicsBuffer sums,
            int count, float side)
        {
            QueryBindings.SetSpace(cmd, kernel, target);
            QueryBindings.SetQueries(cmd, kernel, queries, count);
            kernel.SetBuffer(cmd, BoxSums, sums);
            kernel.SetFloat(cmd, ParticleSide, side);
        }
    }
}
