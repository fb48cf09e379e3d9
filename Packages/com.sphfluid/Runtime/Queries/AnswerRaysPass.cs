using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Answers where rays in the world meet the liquid's surface.</summary>
    internal sealed class AnswerRaysPass : QueryPass
    {
        public const string ShaderName = "AnswerRays";
        public const int Words = 2;

        private static readonly int StepLength = Id("_StepLength");

        private readonly ComputeKernel kernel;

        public AnswerRaysPass(FluidShaderSet shaders)
            : base(shaders, ShaderName)
        {
            kernel = Kernel();
        }

        /// <inheritdoc/>
        public override void Record(CommandBuffer cmd, in QueryTarget target, in QueryBatch asked) =>
            Record(cmd, target, asked.Words, asked.Count, asked.First);

        /// <param name="cmd">Command buffer to record into, after the neighbour setup.</param>
        /// <param name="target">The liquid and the answers.</param>
        /// <param name="queries">Two words a ray: origin [m] and generation, unit direction and length [m].</param>
        /// <param name="count">Number of rays.</param>
        /// <param name="first">Of their answers.</param>
        public void Record(CommandBuffer cmd, in QueryTarget target, GraphicsBuffer queries, int count, int first)
        {
            using (Sample(cmd))
            {
                QueryBindings.SetDensity(cmd, kernel, target);
                QueryBindings.Set(cmd, kernel, target, queries, count, first);
                kernel.SetFloat(cmd, StepLength, 0.5f * target.Solver.Settings.Spacing);
                kernel.DispatchThreads(cmd, count);
            }
        }
    }
}
