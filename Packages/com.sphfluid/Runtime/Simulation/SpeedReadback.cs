using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// How fast the liquid is, always as of the same number of stepped frames ago: however fast the read-backs arrive, the same
    /// liquid takes the same steps. By then the GPU has done that frame; where it has not, this waits for it.
    /// </summary>
    internal sealed class SpeedReadback : IDisposable
    {
        /// <summary>Age of the sample in frames with steps.</summary>
        public const int Delay = 3;

        private readonly FluidSolver solver;
        private readonly MeasureSpeedsPass pass;
        private readonly Slot[] slots = new Slot[Delay];
        private GraphicsBuffer counts, places, claims;
        private int next, keepings;
        private bool keeps, hasPlaces;

        /// <summary>
        /// Starts with a speed of the particles, or the present one where that is faster, and the head that the constants are made for.
        /// </summary>
        /// <param name="solver">The liquid.</param>
        /// <param name="shaders">The shaders.</param>
        /// <param name="speed">Fastest particle until a measurement is there [m/s].</param>
        /// <exception cref="FluidDeviceException">A shader is missing, or the device cannot run it.</exception>
        public SpeedReadback(FluidSolver solver, FluidShaderSet shaders, float speed)
        {
            this.solver = solver;
            pass = new MeasureSpeedsPass(shaders);
            counts = GpuBuffers.Create("Speed Counts", SpeedCounts.Size, sizeof(uint));
            Restart(Mathf.Max(speed, SpeedSample.Finite(solver.ReadCountersNow().MaxSpeed)), solver.Settings.MaxSpeed);
        }

        /// <summary>The liquid of <see cref="Delay"/> frames ago.</summary>
        public SpeedSample Sample
        {
            get
            {
                Slot oldest = slots[next];
                if (!oldest.Known) oldest.Wait();
                return oldest.Sample;
            }
        }

        /// <summary>Part of the particles that did not move at all then, 0 to 1.</summary>
        public float StillShare => slots[next].Still;

        /// <summary>Bytes of GPU memory at the start.</summary>
        public static long PlannedBytes => GpuBuffers.BytesOf(SpeedCounts.Size, sizeof(uint));

        /// <summary>Bytes of GPU memory.</summary>
        public long GpuBytes => Bytes(counts) + Bytes(places) + Bytes(claims);

        /// <summary>Keeps the places of the next recorded frame, for distances from there on.</summary>
        /// <returns>The number that samples with such distances have.</returns>
        public int KeepPlaces()
        {
            keeps = true;
            return ++keepings;
        }

        /// <summary>No distances from the next frame on.</summary>
        public void ForgetPlaces() => keeps = hasPlaces = false;

        /// <summary>The liquid is another one: what was measured before does not count.</summary>
        /// <param name="speed">Fastest particle until a measurement is there [m/s].</param>
        /// <param name="head">Its <see cref="SpeedSample.Head"/> until then [m/s].</param>
        public void Restart(float speed, float head)
        {
            ForgetPlaces();
            for (int i = 0; i < Delay; i++)
            {
                slots[i] =
                    new Slot { Known = true, Sample = new SpeedSample { Fastest = speed, Bulk = speed, Head = head, Present = head } };
            }
        }

        /// <summary>What is known of the last frames, the oldest first, once nothing is under way; for saves.</summary>
        internal void Save(SaveWriter writer)
        {
            writer.Write(keepings);
            for (int i = 0; i < Delay; i++)
            {
                Slot slot = slots[(next + i) % Delay];
                if (!slot.Known) slot.Wait();
                writer.Write(slot.Sample);
            }
        }

        /// <summary>Goes on from a save: no distances until places are kept again.</summary>
        internal void Load(SaveReader reader)
        {
            ForgetPlaces();
            keepings = reader.Read<int>();
            next = 0;
            for (int i = 0; i < Delay; i++) slots[i] = new Slot { Known = true, Sample = reader.Read<SpeedSample>() };
        }

        /// <summary>Records the measurement of a frame's end, after its steps and the neighbour setup.</summary>
        public void Record(CommandBuffer cmd)
        {
            pass.Record(cmd, solver, counts);
            if (keeps)
            {
                int count = Mathf.NextPowerOfTwo(solver.ParticleCount); // ids that follow each other have a place each
                GpuBuffers.Reserve(ref places, "Kept Places", count, 4 * sizeof(float));
                GpuBuffers.Reserve(ref claims, "Kept Place Claims", count, sizeof(uint));
                pass.RecordPlaces(cmd, solver, places, claims);
                keeps = false;
                hasPlaces = true;
            }
            if (hasPlaces) pass.RecordDistances(cmd, solver, places, claims, counts);
        }

        /// <summary>Asks for the measurement when it has been given to the GPU.</summary>
        /// <param name="rest">What each particle takes off the squares of heads, <see cref="SpeedSample.Evaluate"/> [m²/s²].</param>
        public void Request(double rest)
        {
            var slot = new Slot { Sample = Sample, Kept = hasPlaces ? keepings : 0, Rest = rest };
            slots[next] = slot;
            next = (next + 1) % Delay;
            if (SystemInfo.supportsAsyncGPUReadback) slot.Request = AsyncGPUReadback.Request(counts, slot.Receive);
            else slot.Receive(counts);
        }

        /// <inheritdoc/>
        public void Dispose()
        {
            GpuBuffers.Dispose(ref counts);
            GpuBuffers.Dispose(ref places);
            GpuBuffers.Dispose(ref claims);
        }

        private static long Bytes(GraphicsBuffer buffer) => buffer == null ? 0 : (long)buffer.count * buffer.stride;

        private sealed class Slot
        {
            [OutlivesPlay("it is filled anew for each use")] private static readonly uint[] Numbers = new uint[SpeedCounts.Size];

            public AsyncGPUReadbackRequest Request;
            public SpeedSample Sample;
            public bool Known;
            public int Kept;
            public double Rest;
            public float Still;

            public void Receive(AsyncGPUReadbackRequest request)
            {
                if (Known) return;
                Known = true;
                if (request.hasError) return;
                request.GetData<uint>().CopyTo(Numbers);
                Evaluate();
            }

            public void Receive(GraphicsBuffer counts)
            {
                Known = true;
                counts.GetData(Numbers);
                Evaluate();
            }

            private void Evaluate()
            {
                Sample = SpeedSample.Evaluate(Numbers, Kept, Rest);
                Still = SpeedCounts.StillShare(Numbers);
            }

            public void Wait()
            {
                Request.WaitForCompletion();
                Receive(Request);
            }
        }
    }
}
