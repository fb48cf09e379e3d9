using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>The questions of a kind in a frame.</summary>
    internal struct QueryBatch
    {
        /// <summary>Their words, one question after another.</summary>
        public GraphicsBuffer Words;

        /// <summary>How many there are.</summary>
        public int Count;

        /// <summary>How many there may be before a larger buffer is made.</summary>
        public int Capacity;

        /// <summary>Place of the first one's answer.</summary>
        public int First;
    }

    /// <summary>Answers the questions of a kind.</summary>
    internal abstract class QueryPass : ComputePass
    {
        protected QueryPass(FluidShaderSet shaders, string shader)
            : base(shaders, shader)
        {
        }

        /// <summary>Bytes of GPU memory that it keeps from frame to frame.</summary>
        public virtual long GpuBytes => 0;

        /// <summary>Records the answers.</summary>
        /// <param name="cmd">Command buffer to record into, after the neighbour setup.</param>
        /// <param name="target">The liquid and the answers.</param>
        /// <param name="asked">The questions, one or more.</param>
        public abstract void Record(CommandBuffer cmd, in QueryTarget target, in QueryBatch asked);

        /// <summary>Frees the memory.</summary>
        public virtual void Dispose()
        {
        }
    }
}
