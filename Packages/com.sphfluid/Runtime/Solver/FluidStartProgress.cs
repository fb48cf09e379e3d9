namespace SphFluid
{
    /// <summary>How far a liquid has settled.</summary>
    public readonly struct FluidStartProgress
    {
        internal FluidStartProgress(int steps, double seconds, double secondsLeft)
        {
            Steps = steps;
            Seconds = seconds;
            SecondsLeft = secondsLeft;
        }

        /// <summary>Damped steps taken.</summary>
        public int Steps { get; }

        /// <summary>Time that they took [s].</summary>
        public double Seconds { get; }

        /// <summary>Estimate of the time left [s], from how the liquid slows down.</summary>
        public double SecondsLeft { get; }

        /// <summary>Part of the time that is over, 0 to 1.</summary>
        public float Share => Seconds + SecondsLeft > 0.0 ? (float)(Seconds / (Seconds + SecondsLeft)) : 0f;
    }
}
