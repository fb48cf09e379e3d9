using System;

namespace SphFluid
{
    /// <summary>
    /// Turns frame times into whole steps of one length. Leapfrog needs equal steps (thesis 4.3), so a rest waits for the
    /// next frame. Where a frame asks for more steps than allowed, the surplus is dropped and reported: simulated time slows.
    /// </summary>
    internal sealed class StepClock : IStepClock
    {
        // A frame of exactly n steps must give n, however its sum of floats was rounded.
        private const double RoundingSlack = 1e-6;

        private double pending;

        /// <summary>Creates a clock at time zero.</summary>
        /// <param name="timeStep">Length of a step [s], positive.</param>
        /// <param name="maxSteps">Most steps a frame, one or more.</param>
        /// <exception cref="ArgumentOutOfRangeException">An argument is out of range.</exception>
        public StepClock(double timeStep, int maxSteps)
        {
            if (!(timeStep > 0.0) || double.IsInfinity(timeStep))
            {
                throw new ArgumentOutOfRangeException(nameof(timeStep), timeStep, "The time step must be a positive number of seconds.");
            }

            if (maxSteps < 1)
            {
                throw new ArgumentOutOfRangeException(nameof(maxSteps), maxSteps, "A frame must be allowed one step or more.");
            }

            TimeStep = timeStep;
            MaxSteps = maxSteps;
        }

        /// <summary>Length of a step [s].</summary>
        public double TimeStep { get; }

        /// <summary>Most steps a frame.</summary>
        public int MaxSteps { get; }

        /// <summary>Steps given out since the start.</summary>
        public long StepCount { get; private set; }

        /// <summary>Simulated time [s]: steps times their length.</summary>
        public double SimulatedTime => StepCount * TimeStep;

        /// <summary>Time dropped at the cap since the start [s].</summary>
        public double DroppedTime { get; private set; }

        /// <summary>Time dropped in the last call [s].</summary>
        public double LastDroppedTime { get; private set; }

        /// <summary>Adds a frame's time.</summary>
        /// <param name="deltaTime">Time since the last call [s]; not negative.</param>
        /// <returns>Steps to take now.</returns>
        /// <exception cref="ArgumentOutOfRangeException">The time is negative or not finite.</exception>
        public int Advance(double deltaTime)
        {
            if (!(deltaTime >= 0.0) || double.IsInfinity(deltaTime))
            {
                throw new ArgumentOutOfRangeException(nameof(deltaTime), deltaTime, "Frame time must be zero or more.");
            }

            pending += deltaTime;
            double due = Math.Floor(pending / TimeStep + RoundingSlack);
            int steps = (int)Math.Min(due, MaxSteps);
            LastDroppedTime = (due - steps) * TimeStep;
            DroppedTime += LastDroppedTime;
            pending = Math.Max(0.0, pending - due * TimeStep);
            StepCount += steps;
            return steps;
        }

        /// <summary>Counts one step outside the frames' time; time that waits for a step waits on.</summary>
        public void StepOnce()
        {
            LastDroppedTime = 0.0;
            StepCount++;
        }

        /// <summary>Time that waits for a step [s]; for saves.</summary>
        internal double Pending { get => pending; set => pending = value; }

        /// <summary>Back to time zero.</summary>
        public void Reset()
        {
            pending = 0.0;
            StepCount = 0;
            DroppedTime = 0.0;
            LastDroppedTime = 0.0;
        }
    }
}
