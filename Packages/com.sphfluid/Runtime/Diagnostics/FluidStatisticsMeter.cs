using System;
using System.Collections.Generic;
using Unity.Collections;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// Sums a liquid's state on the GPU and brings it to the CPU, without waiting or with. Each group of threads reduces its particles
    /// in a fixed order and the records are added in double precision: the same state gives the same figures to the last bit.
    /// </summary>
    public sealed class FluidStatisticsMeter : IDisposable
    {
        private readonly MeasureStatisticsPass pass;
        private readonly FluidSolver solver;
        private readonly Queue<FluidMoment> pending = new Queue<FluidMoment>();
        private readonly Action<AsyncGPUReadbackRequest> received;
        private Vector4[] values = new Vector4[0];
        private GraphicsBuffer records;

        /// <summary>A meter for a solver.</summary>
        /// <param name="shaders">Shader set with MeasureStatistics.</param>
        /// <param name="solver">The solver; it must outlive the recordings.</param>
        /// <exception cref="FluidDeviceException">The device cannot run it.</exception>
        public FluidStatisticsMeter(FluidShaderSet shaders, FluidSolver solver)
        {
            if (shaders == null)
            {
                throw new ArgumentNullException(nameof(shaders), "A statistics meter needs a shader set: assign one in the fluid profile.");
            }
            this.solver = solver ?? throw new ArgumentNullException(nameof(solver), "A statistics meter needs a running solver.");
            pass = new MeasureStatisticsPass(shaders);
            Reserve();
            received = Receive;
        }

        /// <summary>Raised on the main thread for each asynchronous measurement, oldest first.</summary>
        public event Action<FluidStatistics> Measured;

        /// <summary>The solver that is measured.</summary>
        public FluidSolver Solver => solver;

        /// <summary>Bytes of GPU memory that the meter holds.</summary>
        public long GpuBytes => records == null ? 0 : (long)records.count * records.stride;

        /// <summary>Raised after <see cref="Measured"/> with what was measured.</summary>
        internal event Action<FluidStatistics, FluidMoment> MeasuredAt;

        /// <summary>Measurements that have not arrived.</summary>
        internal int UnderWay => pending.Count;

        /// <summary>
        /// Records a measurement of the present state, and the neighbour setup where it is not fresh: the next step uses it. On devices
        /// with asynchronous read-back <see cref="Measured"/> follows within a few frames.
        /// </summary>
        /// <param name="cmd">Command buffer to record into.</param>
        public void Record(CommandBuffer cmd) => Record(cmd, false);

        /// <summary>Records a measurement, and whether something outside did work on the liquid since the last.</summary>
        internal void Record(CommandBuffer cmd, bool workDone)
        {
            RecordKernel(cmd);
            if (SystemInfo.supportsAsyncGPUReadback)
            {
                pending.Enqueue(new FluidMoment(solver, workDone));
                cmd.RequestAsyncReadback(records, received);
            }
        }

        /// <summary>Measures the present state and waits for the GPU; for tools and tests.</summary>
        /// <returns>The statistics now.</returns>
        public FluidStatistics MeasureNow()
        {
            using (var cmd = new CommandBuffer { name = "Fluid Statistics" })
            {
                RecordKernel(cmd);
                Graphics.ExecuteCommandBuffer(cmd);
            }
            records.GetData(values);
            var moment = new FluidMoment(solver, false);
            return FluidStatisticsRecord.Sum(values, pass.Groups(moment.ParticleCount), moment);
        }

        /// <summary>Frees the GPU memory. Measurements that have not arrived are dropped.</summary>
        public void Dispose() => GpuBuffers.Dispose(ref records);

        private void RecordKernel(CommandBuffer cmd)
        {
            if (records == null) throw new ObjectDisposedException(nameof(FluidStatisticsMeter));
            solver.RecordNeighbourSetup(cmd);
            Reserve();
            pass.Record(cmd, solver, records);
        }

        // A read-back that is under way has the buffer that it was asked of.
        private void Reserve()
        {
            int length = pass.Groups(solver.ParticleCount) * FluidStatisticsRecord.Size;
            if (values.Length >= length) return;
            if (records != null) solver.State.Retired.Add(records);
            values = new Vector4[Math.Max(length, 2 * values.Length)];
            records = GpuBuffers.Create("Statistics", values.Length, 4 * sizeof(float));
        }

        private void Receive(AsyncGPUReadbackRequest request)
        {
            if (records == null) return;
            FluidMoment moment = pending.Dequeue();
            if (request.hasError) return;
            NativeArray<Vector4> data = request.GetData<Vector4>();
            NativeArray<Vector4>.Copy(data, values, data.Length);
            FluidStatistics statistics = FluidStatisticsRecord.Sum(values, pass.Groups(moment.ParticleCount), moment);
            Measured?.Invoke(statistics);
            MeasuredAt?.Invoke(statistics, moment);
        }
    }
}
