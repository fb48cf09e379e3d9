using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Answers which particle is nearest to places in the world.</summary>
    internal sealed class AnswerNearestPass : QueryPass
    {
        public const string ShaderName = "AnswerNearest";
        public const int Words = 2;

        private const int GroupThreads = 256;

        private static readonly int ParticleCount = Id("_ParticleCount");

        private readonly ComputeKernel kernel;

        public AnswerNearestPass(FluidShaderSet shaders)
            : base(shaders, ShaderName)
        {
            kernel = Kernel();
        }

        /// <inheritdoc/>
        public override void Record(CommandBuffer cmd, in QueryTarget target, in QueryBatch asked) =>
            Record(cmd, target, asked.Words, asked.Count, asked.First);

        /// <param name="cmd">Command buffer to record into, after the neighbour setup.</param>
        /// <param name="target">The liquid and the answers.</param>
        /// <param name="queries">Two words a place: world position [m] and generation, and nothing and how far to look [m].</param>
        /// <param name="count">Number of places.</param>
        /// <param name="first">Of their answers.</param>
        public void Record(CommandBuffer cmd, in QueryTarget target, GraphicsBuffer queries, int count, int first)
        {
            using (Sample(cmd))
            {
                QueryBindings.Set(cmd, kernel, target, queries, count, first);
                kernel.SetInt(cmd, ParticleCount, target.Solver.ParticleCount);
                kernel.DispatchThreads(cmd, GroupThreads * count);
            }
        }
    }
}
