namespace SphFluid
{
    /// <summary>What the overlay shows of a liquid.</summary>
    internal struct LiquidFigures
    {
        /// <summary>Name of the simulation's object.</summary>
        public string Name;

        /// <summary>"running", perhaps with the part that is asleep, "paused", "asleep" or "stopped".</summary>
        public string State;

        /// <summary>The method that was picked automatically, with its cost; null: it is given.</summary>
        public string Method;

        /// <summary>Its level of detail and why; null: it has all always.</summary>
        public string Detail;

        /// <summary>Whether there is a liquid; the numbers below are of it.</summary>
        public bool Runs;

        /// <summary>Particles that are in the liquid.</summary>
        public long Particles;

        /// <summary>Particles that its buffers have room for.</summary>
        public long Slots;

        /// <summary>Particles that left since the start.</summary>
        public long Removed;

        /// <summary>Particles that found no slot since the start.</summary>
        public long Refused;

        /// <summary>Mean steps a frame since the last text.</summary>
        public double StepsPerFrame;

        /// <summary>Mean neighbour set-ups a frame since the last text.</summary>
        public double SetupsPerFrame;

        /// <summary>Frames since the last text that needed more steps than allowed.</summary>
        public long CapHits;

        /// <summary>Most steps a frame.</summary>
        public int MostSteps;

        /// <summary>Length of a step [s].</summary>
        public double TimeStep;

        /// <summary>Simulated time over real time.</summary>
        public double RealTimeFactor;

        /// <summary>What limits the time step.</summary>
        public TimeStepLimit Limit;

        /// <summary>GPU memory [bytes].</summary>
        public long Bytes;

        /// <summary>The worst message; empty: none.</summary>
        public string Message;
    }
}
