using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// The bodies' states on the CPU, always of the same number of frames ago: however fast read-backs arrive, equal runs stay equal. By
    /// then the GPU has done that frame; where it has not, this waits for it.
    /// </summary>
    internal sealed class FloatingReadback
    {
        private readonly Queue<Slot> slots = new Queue<Slot>();
        private readonly Stack<Slot> free = new Stack<Slot>();

        /// <summary>Age at which a frame's states are taken, in frames with steps; 1 or more.</summary>
        public int Age { get; set; } = 2;

        /// <summary>Asks for the states of a frame whose commands have been given to the GPU.</summary>
        public void Request(GraphicsBuffer states, int count, long frame)
        {
            Slot slot = free.Count > 0 ? free.Pop() : new Slot();
            slot.Ask(states, count, frame);
            slots.Enqueue(slot);
        }

        /// <summary>
        /// Hands on what is old enough; for a body that has just come, all: until then its owner knows nothing of the liquid.
        /// </summary>
        /// <param name="bodies">By number less one; null where a number is free.</param>
        /// <param name="frame">The frame that follows.</param>
        public void Deliver(IReadOnlyList<FloatingBody> bodies, long frame)
        {
            bool hurries = false;
            for (int i = 0; i < bodies.Count; i++) hurries |= bodies[i] != null && bodies[i].IsAwaited;
            while (slots.Count > 0 && (hurries || slots.Peek().Frame <= frame - Age))
            {
                Slot slot = slots.Dequeue();
                slot.Deliver(bodies);
                free.Push(slot);
            }
        }

        /// <summary>Writes what is under way, waiting for it.</summary>
        public void Save(SaveWriter writer)
        {
            writer.Write(slots.Count);
            foreach (Slot slot in slots) slot.Save(writer);
        }

        /// <summary>Goes on from a save.</summary>
        public void Load(SaveReader reader)
        {
            slots.Clear();
            for (int left = reader.Read<int>(); left > 0; left--) slots.Enqueue(Slot.Load(reader));
        }

        private sealed class Slot
        {
            private readonly System.Action<AsyncGPUReadbackRequest> received;
            private FloatingState[] states = new FloatingState[4];
            private AsyncGPUReadbackRequest request;
            private int count;
            private bool known, hasError;

            public Slot()
            {
                received = Receive;
            }

            public long Frame { get; private set; }

            public void Ask(GraphicsBuffer buffer, int number, long frame)
            {
                Frame = frame;
                count = number;
                known = hasError = false;
                if (states.Length < count) states = new FloatingState[Mathf.NextPowerOfTwo(count)];
                if (SystemInfo.supportsAsyncGPUReadback)
                {
                    request = AsyncGPUReadback.Request(buffer, count * FloatingState.Stride, 0, received);
                    return;
                }

                buffer.GetData(states, 0, 0, count);
                known = true;
            }

            public void Save(SaveWriter writer)
            {
                Wait();
                writer.Write(Frame);
                writer.WriteItems(states, hasError ? 0 : count);
            }

            public static Slot Load(SaveReader reader)
            {
                var slot = new Slot { Frame = reader.Read<long>(), states = reader.ReadItems<FloatingState>(), known = true };
                slot.count = slot.states.Length;
                return slot;
            }

            public void Deliver(IReadOnlyList<FloatingBody> bodies)
            {
                Wait();
                for (int i = 0; i < count && i < bodies.Count && !hasError; i++) bodies[i]?.Receive(states[i], Frame);
            }

            private void Wait()
            {
                if (known) return;
                request.WaitForCompletion();
                Receive(request);
            }

            private void Receive(AsyncGPUReadbackRequest done)
            {
                if (known) return;
                known = true;
                hasError = done.hasError;
                if (!hasError) Unity.Collections.NativeArray<FloatingState>.Copy(done.GetData<FloatingState>(), 0, states, 0, count);
            }
        }
    }
}
