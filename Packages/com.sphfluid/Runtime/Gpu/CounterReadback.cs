using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Brings the counter buffer (Shaders/Gpu/FluidCounters.hlsl) to the CPU without waiting for the GPU.</summary>
    internal sealed class CounterReadback : IDisposable
    {
        public const int Slots = 17;
        private const int AccelerationLimit = 0;
        private const int DomainClamp = 1;
        private const int NonFinite = 2;
        private const int Shortened = 3;
        private const int ContactFallback = 4;
        private const int Squeezed = 5;
        private const int Overlap = 6;
        private const int Contact = 7;
        private const int Removed = 8;
        private const int Born = 9;
        private const int Blocked = 10;
        private const int Refused = 11;
        private const int ImpulseLimit = 12;
        private const int LeftThroughFace = 13;
        internal const int MaxSpeed = 14;
        private const int MaxDensity = 15;
        private const int SqueezersSlot = 16;
        private const int FirstMaximum = 14;

        private static readonly uint[] Zeros = new uint[Slots];

        private readonly GraphicsBuffer buffer;
        private readonly NumberReadback readback;
        private readonly uint[] last = new uint[Slots];
        private FluidCounters counters;

        public CounterReadback(GraphicsBuffer buffer, float restDensity)
        {
            this.buffer = buffer;
            RestDensity = restDensity;
            readback = new NumberReadback(Slots, Receive);
        }

        public FluidCounters Counters => counters;

        /// <summary>
        /// Numbers of two bodies that left a particle no place last, from 1 on, in 16 bits each, the larger first; 0: none.
        /// </summary>
        public uint Squeezers { get; private set; }

        /// <summary>Of the removed, those that left through a face; not in saves, unlike the counters.</summary>
        public long LeftThroughFaces { get; private set; }

        public float RestDensity { get; set; }

        /// <summary>Requested read-backs that have arrived.</summary>
        public long Received => readback.Received;

        /// <summary>Records the start of a batch of steps: maxima begin anew, counts go on.</summary>
        public void RecordReset(CommandBuffer cmd)
        {
            cmd.SetBufferData(buffer, Zeros, FirstMaximum, FirstMaximum, Slots - FirstMaximum);
        }

        /// <summary>Records the read-back; devices without asynchronous read-back use <see cref="ReadNow"/>.</summary>
        public void RecordRequest(CommandBuffer cmd)
        {
            readback.RecordRequest(cmd, buffer);
        }

        /// <summary>Waits for the GPU and reads the counters.</summary>
        public FluidCounters ReadNow()
        {
            readback.ReadNow(buffer);
            return counters;
        }

        /// <summary>Goes on from other counts: what the GPU counts from now on is added to them.</summary>
        public void Continue(in FluidCounters from)
        {
            ReadNow();
            counters = from;
            Squeezers = 0u;
        }

        public void Dispose()
        {
            readback.Dispose();
        }

        private void Receive(uint[] values)
        {
            counters.AccelerationLimitHits += Added(values, AccelerationLimit);
            counters.DomainClamps += Added(values, DomainClamp);
            counters.NonFinite += Added(values, NonFinite);
            counters.ShortenedSteps += Added(values, Shortened);
            counters.ContactFallbacks += Added(values, ContactFallback);
            counters.Squeezed += Added(values, Squeezed);
            counters.Overlaps += Added(values, Overlap);
            counters.Contacts += Added(values, Contact);
            int left = Added(values, LeftThroughFace);
            LeftThroughFaces += left;
            counters.Removed += Added(values, Removed) + left;
            counters.Born += Added(values, Born);
            counters.Blocked += Added(values, Blocked);
            counters.Refused += Added(values, Refused);
            counters.ImpulseLimits += Added(values, ImpulseLimit);
            if (values[SqueezersSlot] != 0u) Squeezers = values[SqueezersSlot];
            counters.MaxSpeed = ToFloat(values[MaxSpeed]);
            counters.MaxCompression = Mathf.Max(0f, ToFloat(values[MaxDensity]) / RestDensity - 1f);
        }

        // The GPU counts modulo 2^32; a difference survives the overflow. A read-back older than ReadNow's adds nothing.
        private int Added(uint[] values, int slot)
        {
            int added = unchecked((int)(values[slot] - last[slot]));
            if (added <= 0) return 0;

            last[slot] = values[slot];
            return added;
        }

        private static float ToFloat(uint bits)
        {
            return BitConverter.Int32BitsToSingle(unchecked((int)bits));
        }
    }
}
