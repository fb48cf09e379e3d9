using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>The passes that answer the questions of a frame, each only where its kind is asked.</summary>
    internal sealed class QueryPasses : IDisposable
    {
        readonly AnswerPointsPass points;
        readonly AnswerRaysPass rays;
        readonly AnswerBoxesPass boxes;
        readonly AnswerNearestPass nearest;
        readonly AnswerPatchesPass patches;
        readonly PatchSums flows = new PatchSums();
        GraphicsBuffer boxSums;

        /// <exception cref="FluidDeviceException">A shader is missing, or the device cannot run it.</exception>
        public QueryPasses(FluidShaderSet shaders)
        {
            points = new AnswerPointsPass(shaders);
            rays = new AnswerRaysPass(shaders);
            boxes = new AnswerBoxesPass(shaders);
            nearest = new AnswerNearestPass(shaders);
            patches = new AnswerPatchesPass(shaders);
        }

        /// <summary>Bytes of GPU memory.</summary>
        public long GpuBytes => GpuBuffers.Size(boxSums) + flows.GpuBytes;

        /// <summary>Records the answers, kind after kind.</summary>
        /// <param name="cmd">Command buffer to record into, after the neighbour setup.</param>
        /// <param name="target">The liquid and the answers.</param>
        /// <param name="asked">The requests.</param>
        /// <param name="firsts">Where the answers of each kind begin.</param>
        public void Record(CommandBuffer cmd, in QueryTarget target, QuerySet asked, int[] firsts)
        {
            RetiredBuffers retired = target.Solver.State.Retired;
            for (QueryKind kind = 0; (int)kind < firsts.Length - 1; kind++)
            {
                QuerySlots slots = asked[kind];
                int count = slots.Used, first = firsts[(int)kind];
                if (count == 0) continue;
                switch (kind)
                {
                    case QueryKind.Point:
                        points.Record(cmd, target, slots.Buffer, count, first);
                        break;
                    case QueryKind.Ray:
                        rays.Record(cmd, target, slots.Buffer, count, first);
                        break;
                    case QueryKind.Box:
                        ReserveBoxes(AnswerBoxesPass.Sums * slots.Capacity, retired);
                        boxes.Record(cmd, target, slots.Buffer, boxSums, count, first);
                        break;
                    case QueryKind.Nearest:
                        nearest.Record(cmd, target, slots.Buffer, count, first);
                        break;
                    case QueryKind.Patch:
                        flows.Reserve(slots.Capacity, target.Solver.ParticleCount, retired);
                        patches.Record(cmd, target, slots.Buffer, flows, count, first);
                        break;
                }
            }
        }

        public void Dispose()
        {
            GpuBuffers.Dispose(ref boxSums);
            flows.Dispose();
        }

        void ReserveBoxes(int sums, RetiredBuffers retired)
        {
            if (boxSums != null && boxSums.count >= sums) return;
            if (boxSums != null) retired.Add(boxSums);
            boxSums = GpuBuffers.Create("Fluid Box Sums", sums, sizeof(uint));
            boxSums.SetData(new uint[sums]);
        }
    }
}
