using System;
using System.Collections.Generic;
using System.Threading;

namespace SphFluid
{
    /// <summary>A frame that cannot be shown.</summary>
    internal readonly struct SequenceFailure
    {
        public SequenceFailure(int frame, string text, string cure)
        {
            Frame = frame;
            Text = text;
            Cure = cure;
        }

        /// <summary>Its number.</summary>
        public int Frame { get; }

        /// <summary>What is wrong; goes on behind the file's name.</summary>
        public string Text { get; }

        /// <summary>What to do.</summary>
        public string Cure { get; }
    }

    /// <summary>
    /// Reads frames ahead on a thread of its own, into memory that is there from the start: those that are needed next are in it as soon as
    /// they can be. A frame that cannot be read is told once and not tried again.
    /// </summary>
    internal sealed class SequenceLoader : IDisposable
    {
        private const int Nowhere = -1;

        private readonly object gate = new object();
        private readonly ISequenceReader reader;
        private readonly SequenceSlot[] slots;
        private readonly int[] slotOf, wantedAt, wanted;
        private readonly bool[] failed;
        private readonly Queue<SequenceFailure> failures = new Queue<SequenceFailure>();
        private readonly Thread thread;
        private SequenceWalk walk;
        private int wantedCount, turn;
        private bool ends;

        /// <param name="reader">Reads a frame.</param>
        /// <param name="frames">Number of frames.</param>
        /// <param name="slots">Frames that are held, two or more unless there are fewer.</param>
        /// <param name="capacity">Most particles of a frame.</param>
        public SequenceLoader(ISequenceReader reader, int frames, int slots, int capacity)
        {
            this.reader = reader;
            this.slots = new SequenceSlot[slots];
            for (int i = 0; i < slots; i++) this.slots[i] = new SequenceSlot(capacity);
            (slotOf, wantedAt, wanted, failed) = (new int[frames], new int[frames], new int[slots], new bool[frames]);
            Array.Fill(slotOf, Nowhere);
            thread = new Thread(Run) { Name = "Fluid Playback", IsBackground = true };
            thread.Start();
        }

        /// <summary>Frames that were read.</summary>
        public long Reads { get; private set; }

        /// <summary>Says what is needed from now on. Frames on the way there stay as they are until this is called again.</summary>
        /// <param name="next">The frames, in the order in which they are needed.</param>
        public void Want(in SequenceWalk next)
        {
            lock (gate)
            {
                if (turn > 0 && next.Is(walk)) return;
                walk = next;
                Choose();
                Monitor.PulseAll(gate);
            }
        }

        /// <summary>A frame among those that are needed; null where it is not there yet.</summary>
        public SequenceSlot Find(int frame)
        {
            lock (gate) return SlotOf(frame);
        }

        /// <summary>Whether a frame cannot be read.</summary>
        public bool HasFailed(int frame)
        {
            lock (gate) return failed[frame];
        }

        /// <summary>Waits until a frame that is needed is there, or cannot be read.</summary>
        public void WaitFor(int frame)
        {
            lock (gate)
                while (SlotOf(frame) == null && !failed[frame]) Monitor.Wait(gate);
        }

        /// <summary>Takes one of the frames that turned out not to be readable.</summary>
        public bool TryTakeFailure(out SequenceFailure failure)
        {
            lock (gate) return failures.TryDequeue(out failure);
        }

        /// <summary>Ends the thread, after the frame that it reads, and frees the memory.</summary>
        public void Dispose()
        {
            lock (gate)
            {
                ends = true;
                Monitor.PulseAll(gate);
            }
            thread.Join();
            foreach (SequenceSlot slot in slots) slot.Dispose();
        }

        private SequenceSlot SlotOf(int frame) => slotOf[frame] != Nowhere && slots[slotOf[frame]].IsReady ? slots[slotOf[frame]] : null;

        // As many as are held, without those that cannot be read.
        private void Choose()
        {
            turn++;
            wantedCount = 0;
            SequenceWalk at = walk;
            for (int left = 2 * slotOf.Length; left > 0 && wantedCount < wanted.Length; left--)
            {
                if (!failed[at.Frame] && wantedAt[at.Frame] != turn)
                {
                    wantedAt[at.Frame] = turn;
                    wanted[wantedCount++] = at.Frame;
                }
                if (!at.Next()) break;
            }
        }

        private void Run()
        {
            while (true)
            {
                int frame;
                SequenceSlot slot;
                lock (gate)
                {
                    while (!TryPick(out frame, out slot) && !ends) Monitor.Wait(gate);
                    if (ends) return;
                    if (slot.Frame >= 0) slotOf[slot.Frame] = Nowhere;
                    (slot.Frame, slot.IsReady) = (frame, false);
                    slotOf[frame] = Array.IndexOf(slots, slot);
                }
                SequenceFailure? failure = null;
                try
                {
                    reader.Read(frame, slot);
                }
                catch (SequenceException exception)
                {
                    failure = new SequenceFailure(frame, exception.Message, exception.Cure);
                }
                catch (Exception exception) // of the system, or of a file that nobody thought of: no reason to end the program
                {
                    failure = new SequenceFailure(frame, $"cannot be read ({exception.Message.TrimEnd('.')})",
                        "See that the file is there and may be read, then enable the Fluid Playback again.");
                }
                lock (gate)
                {
                    Reads++;
                    if (failure is SequenceFailure told) Drop(slot, told);
                    else slot.IsReady = true;
                    Monitor.PulseAll(gate);
                }
            }
        }

        private void Drop(SequenceSlot slot, in SequenceFailure failure)
        {
            failed[failure.Frame] = true;
            failures.Enqueue(failure);
            slotOf[failure.Frame] = Nowhere;
            slot.Frame = -1;
            Choose();
        }

        // The first frame that is needed and not there, and memory of one that is not needed.
        private bool TryPick(out int frame, out SequenceSlot slot)
        {
            for (int i = 0; i < wantedCount; i++)
            {
                frame = wanted[i];
                if (slotOf[frame] != Nowhere) continue;
                foreach (SequenceSlot held in slots)
                {
                    if (held.Frame >= 0 && wantedAt[held.Frame] == turn) continue;
                    slot = held;
                    return true;
                }
                break;
            }
            (frame, slot) = (-1, null);
            return false;
        }
    }
}
