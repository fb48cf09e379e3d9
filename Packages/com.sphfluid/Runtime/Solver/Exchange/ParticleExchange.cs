using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// Particles that come and go while a liquid runs. The GPU knows how many live; the CPU knows a number that they cannot exceed, by
    /// which it dispatches and makes slots, so that nothing waits and nothing but the GPU's own count decides what is born.
    /// </summary>
    internal sealed class ParticleExchange : IDisposable
    {
        /// <summary>Most drains of a liquid.</summary>
        public const int MostDrains = 64;

        // Bins of the ages, and what the search keeps behind them.
        private const int AgeNumbers = 258;

        private readonly FluidState state;
        private readonly IExchangingStepper stepper;
        private readonly DrainZone[] zones = new DrainZone[MostDrains];
        private GraphicsBuffer zoneBuffer, ageBuffer, birthBuffer, expiredBuffer;
        private int drains, due, expired, ceiling;
        private bool zonesChanged;

        /// <param name="state">The liquid's buffers.</param>
        /// <param name="stepper">What steps it.</param>
        /// <param name="nextId">An id that no particle has, nor those that follow.</param>
        public ParticleExchange(FluidState state, IExchangingStepper stepper, uint nextId)
        {
            this.state = state;
            this.stepper = stepper;
            Births = new BirthQueue(nextId);
            Counts = new SourceCounts();
            ceiling = int.MaxValue;
        }

        /// <summary>Particles that wait for their birth.</summary>
        public BirthQueue Births { get; }

        /// <summary>When particles leave again.</summary>
        public ParticleLifetimes Lifetimes { get; } = new ParticleLifetimes();

        /// <summary>What sources gave and drains took.</summary>
        public SourceCounts Counts { get; }

        /// <summary>Most particles that the liquid may have.</summary>
        public int MostParticles { get; set; } = int.MaxValue;

        /// <summary>Whether the oldest leave where there would be more, or what is born is refused.</summary>
        public bool Recycles { get; set; }

        /// <summary>Whether anything comes or goes with the next steps.</summary>
        public bool IsActive => Births.Waiting > 0 || drains > 0;

        /// <summary>Bytes of GPU memory.</summary>
        public long GpuBytes => GpuBuffers.Size(zoneBuffer, ageBuffer, birthBuffer, expiredBuffer, Counts.Buffer);

        /// <summary>Gives the drains that act from the next steps on.</summary>
        /// <param name="list">Drains and the sources that count for them.</param>
        /// <exception cref="ArgumentException">There are more than <see cref="MostDrains"/>.</exception>
        public void SetDrains(IReadOnlyList<(DrainZone zone, int source)> list)
        {
            if (list.Count > MostDrains)
            {
                throw new ArgumentException($"A liquid has {MostDrains} drains at most, and {list.Count} are given.", nameof(list));
            }
            drains = list.Count;
            for (int i = 0; i < drains; i++) zones[i] = list[i].zone.CountedAt(SourceCounts.Place(list[i].source));
            zonesChanged = true;
        }

        /// <summary>Lowers the number of slots in use to what the GPU's counts leave possible.</summary>
        /// <param name="live">Live particles as of the last read-back.</param>
        /// <param name="attempted">Births that had been given to the GPU by then, whatever became of them.</param>
        public void Bound(long live, long attempted)
        {
            long most = live + Births.Taken - attempted;
            state.ParticleCount = (int)Math.Max(1, Math.Min(state.ParticleCount, most));
        }

        /// <summary>Records the particles that leave in a step that sorts, before its motion.</summary>
        /// <param name="cmd">Command buffer.</param>
        /// <param name="end">Simulated time at its end [s].</param>
        /// <param name="length">Its length [s].</param>
        public void RecordLeaving(CommandBuffer cmd, double end, float length)
        {
            state.ParticleCount = Math.Min(state.ParticleCount, ceiling); // the sort has left the recycled behind
            ceiling = int.MaxValue;
            expired = Lifetimes.RemoveDue(end, Births.Unborn);
            due = Births.CollectDue(end, length, state.Settings.Gravity);
            bool recycles = Recycles && due > 0 && (long)state.ParticleCount + due > MostParticles;
            if (drains == 0 && expired == 0 && !recycles) return;
            stepper.RecordDrains(cmd, Drains(cmd, recycles));
            state.IsDrained = true;
            if (recycles) ceiling = MostParticles;
        }

        /// <summary>Records the births at the end of that step, after its motion.</summary>
        public void RecordBirths(CommandBuffer cmd)
        {
            state.IsDrained = false;
            if (due == 0) return;
            long most = (long)MostParticles + (Recycles ? due : 0);
            long needed = Math.Min((long)state.ParticleCount + due, most);
            if (needed > state.Capacity)
            {
                stepper.Reserve(cmd, (int)Math.Min(Math.Max(2L * state.Capacity, needed), Math.Min(most, int.MaxValue)));
            }
            Upload(cmd, ref birthBuffer, "Fluid Births", Births.Due, due, ParticleBirth.Stride);
            stepper.RecordBirths(cmd,
                new BirthBatch(birthBuffer, Counts.Buffer, due, (int)Math.Min(state.Capacity, most), Births.HasRivals));
            state.ParticleCount = (int)Math.Min((long)state.ParticleCount + due, state.Capacity);
            due = 0;
        }

        /// <summary>Writes what waits and what was counted.</summary>
        public void Save(SaveWriter writer)
        {
            Births.Save(writer);
            Lifetimes.Save(writer);
            Counts.Save(writer);
        }

        /// <summary>Goes on from a save, with the particles of it.</summary>
        public void Load(SaveReader reader)
        {
            Births.Load(reader);
            Lifetimes.Load(reader);
            Counts.Load(reader);
            ceiling = int.MaxValue;
        }

        public void Dispose()
        {
            Counts.Dispose();
            GpuBuffers.Dispose(ref zoneBuffer);
            GpuBuffers.Dispose(ref ageBuffer);
            GpuBuffers.Dispose(ref birthBuffer);
            GpuBuffers.Dispose(ref expiredBuffer);
        }

        private DrainBatch Drains(CommandBuffer cmd, bool recycles)
        {
            if (zonesChanged || zoneBuffer == null)
            {
                Upload(cmd, ref zoneBuffer, "Fluid Drains", zones, Math.Max(1, drains), DrainZone.Stride);
            }
            zonesChanged = false;
            Upload(cmd, ref expiredBuffer, "Fluid Expired", Lifetimes.Due, 1 + expired, IdRange.Stride);
            if (recycles && ageBuffer == null)
            {
                ageBuffer = GpuBuffers.Create("Fluid Ages", AgeNumbers, sizeof(uint));
                ageBuffer.SetData(new uint[AgeNumbers]);
            }
            return new DrainBatch
            {
                Zones = zoneBuffer,
                Counts = Counts.Buffer,
                Ages = ageBuffer,
                Expired = expiredBuffer,
                Count = drains,
                Recycles = recycles,
                Births = due,
                MostParticles = MostParticles,
                NextId = Births.NextId,
                RecycledCount = SourceCounts.Place(SourceCounts.Recycled),
            };
        }

        // What the command buffer recorded before still uses a buffer that is replaced.
        private void Upload(CommandBuffer cmd, ref GraphicsBuffer buffer, string name, Array items, int count, int stride)
        {
            if (buffer == null || buffer.count < count)
            {
                if (buffer != null) state.Retired.Add(buffer);
                buffer = GpuBuffers.Create(name, Math.Max(64, Mathf.NextPowerOfTwo(count)), stride);
            }
            cmd.SetBufferData(buffer, items, 0, 0, count);
        }
    }
}
