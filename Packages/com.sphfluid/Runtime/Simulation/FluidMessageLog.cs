using System.Collections.Generic;

namespace SphFluid
{
    /// <summary>What a simulation has said since its last start, each message once.</summary>
    internal sealed class FluidMessageLog
    {
        private readonly List<FluidMessage> messages = new List<FluidMessage>();

        /// <summary>The messages, in the order in which they came.</summary>
        public IReadOnlyList<FluidMessage> All => messages;

        /// <summary>Takes a message and writes it to the console, unless it is there already.</summary>
        /// <returns>Whether it is new.</returns>
        public bool TryAdd(FluidMessage message)
        {
            if (messages.Contains(message)) return false;
            messages.Add(message);
            message.Log();
            return true;
        }

        /// <summary>Begins anew.</summary>
        /// <returns>What was there.</returns>
        public List<FluidMessage> Clear()
        {
            List<FluidMessage> earlier = messages.GetRange(0, messages.Count);
            messages.Clear();
            return earlier;
        }

        /// <summary>Puts back what was there before the present messages.</summary>
        public void PutBack(List<FluidMessage> earlier) => messages.InsertRange(0, earlier.FindAll(m => !messages.Contains(m)));
    }
}
