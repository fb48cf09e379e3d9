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
        GraphicsBuffer boxSums;

        /// <exception cref="FluidDeviceException">A shader is missing, or the device cannot run it.</exception>
        public QueryPasses(FluidShaderSet shaders)
        {
            points = new AnswerPointsPass(shaders);
            rays = new AnswerRaysPass(shaders);
            boxes = new AnswerBoxesPass(shaders);
        }

        /// <summary>Bytes of GPU memory.</summary>
        public long GpuBytes => GpuBuffers.Size(boxSums);

        /// <summary>Records the answers: of points first, then of rays, then of boxes.</summary>
        public void Record(CommandBuffer cmd, in QueryTarget target, QuerySlots asked, QuerySlots askedRays, QuerySlots askedBoxes)
        {
            if (asked.Used > 0) points.Record(cmd, target, asked.Buffer, asked.Used, 0);
            if (askedRays.Used > 0) rays.Record(cmd, target, askedRays.Buffer, askedRays.Used, asked.Used);
            if (askedBoxes.Used == 0) return;
            int sums = AnswerBoxesPass.Sums * askedBoxes.Capacity;
            if (boxSums == null || boxSums.count < sums)
            {
                if (boxSums != null) target.Solver.State.Retired.Add(boxSums);
                boxSums = GpuBuffers.Create("Fluid Box Sums", sums, sizeof(uint));
                boxSums.SetData(new uint[sums]);
            }
            boxes.Record(cmd, target, askedBoxes.Buffer, boxSums, askedBoxes.Used, asked.Used + askedRays.Used);
        }

        public void Dispose() => GpuBuffers.Dispose(ref boxSums);
    }
}
