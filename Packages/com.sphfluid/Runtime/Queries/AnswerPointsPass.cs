using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Answers what the liquid is at points in the world.</summary>
    internal sealed class AnswerPointsPass : QueryPass
    {
        public const string ShaderName = "AnswerPoints";

        private static readonly int Pressure = Id("_Pressure");

        private readonly ComputeKernel kernel;

        public AnswerPointsPass(FluidShaderSet shaders)
            : base(shaders, ShaderName)
        {
            kernel = Kernel();
        }

        /// <inheritdoc/>
        public override void Record(CommandBuffer cmd, in QueryTarget target, in QueryBatch asked) =>
            Record(cmd, target, asked.Words, asked.Count, asked.First);

        /// <param name="cmd">Command buffer to record into, after the neighbour setup.</param>
        /// <param name="target">The liquid and the answers.</param>
        /// <param name="queries">World position [m] and generation of each point, a word.</param>
        /// <param name="count">Number of points.</param>
        /// <param name="first">Of their answers.</param>
        public void Record(CommandBuffer cmd, in QueryTarget target, GraphicsBuffer queries, int count, int first)
        {
            using (Sample(cmd))
            {
                QueryBindings.SetDensity(cmd, kernel, target);
                QueryBindings.Set(cmd, kernel, target, queries, count, first);
                kernel.SetBuffer(cmd, Pressure, target.Solver.Pressure);
                kernel.DispatchThreads(cmd, count);
            }
        }
    }
}
