namespace SphFluid
{
    /// <summary>What a step, or a few, gave to a <see cref="WallPatch"/>.</summary>
    public readonly struct WallSample
    {
        /// <summary>Simulated time at its end [s].</summary>
        public readonly double Time;

        /// <summary>
        /// Its length [s]: velocities live between the steps, so a step counts from the middle of the one before to its own middle, the
        /// first by half.
        /// </summary>
        public readonly double Seconds;

        /// <summary>Impulse on the wall, against the patch's normal [N s].</summary>
        public readonly double Impulse;

        /// <summary>Mean force on the wall [N].</summary>
        public double Force => Impulse / Seconds;

        internal WallSample(double time, double seconds, double impulse)
        {
            Time = time;
            Seconds = seconds;
            Impulse = impulse;
        }
    }
}
