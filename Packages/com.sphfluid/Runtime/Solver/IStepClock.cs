namespace SphFluid
{
    /// <summary>Turns frame times into steps.</summary>
    internal interface IStepClock
    {
        /// <summary>Length of the steps of the last frame, positive [s].</summary>
        double TimeStep { get; }

        /// <summary>Most steps a frame.</summary>
        int MaxSteps { get; }

        /// <summary>Time dropped at the cap in the last frame [s].</summary>
        double LastDroppedTime { get; }

        /// <summary>Adds a frame's time.</summary>
        /// <param name="deltaTime">Time since the last call [s]; not negative.</param>
        /// <returns>Steps to take now.</returns>
        int Advance(double deltaTime);

        /// <summary>
        /// Takes one step outside the frames' time: <see cref="TimeStep"/> is its length, and time that waits for a step waits on.
        /// </summary>
        void StepOnce();
    }
}
