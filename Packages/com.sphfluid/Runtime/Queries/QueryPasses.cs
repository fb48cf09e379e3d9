using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>The passes that answer the questions of a frame, each only where its kind is asked.</summary>
    internal sealed class QueryPasses
    {
        private readonly QueryPass[] passes = new QueryPass[QueryKind.All.Count];

        /// <exception cref="FluidDeviceException">A shader is missing, or the device cannot run it.</exception>
        public QueryPasses(FluidShaderSet shaders)
        {
            foreach (QueryKind kind in QueryKind.All) passes[kind.Index] = kind.MakePass(shaders);
        }

        /// <summary>Bytes of GPU memory.</summary>
        public long GpuBytes
        {
            get
            {
                long sum = 0;
                foreach (QueryPass pass in passes) sum += pass.GpuBytes;
                return sum;
            }
        }

        /// <summary>Records the answers, kind after kind.</summary>
        /// <param name="cmd">Command buffer to record into, after the neighbour setup.</param>
        /// <param name="target">The liquid and the answers.</param>
        /// <param name="asked">The requests.</param>
        /// <param name="firsts">Where the answers of each kind begin.</param>
        public void Record(CommandBuffer cmd, in QueryTarget target, QuerySet asked, int[] firsts)
        {
            for (int i = 0; i < passes.Length; i++)
            {
                QuerySlots slots = asked[QueryKind.All[i]];
                if (slots.Used == 0) continue;
                passes[i]
                    .Record(cmd, target,
                        new QueryBatch { Words = slots.Buffer, Count = slots.Used, Capacity = slots.Capacity, First = firsts[i] });
            }
        }

        public void Dispose()
        {
            foreach (QueryPass pass in passes) pass.Dispose();
        }
    }
}
