using System;

namespace SphFluid
{
    /// <summary>When a part of a liquid is calm, and when it sleeps; SI.</summary>
    internal readonly struct SleepRule
    {
        // Of the speed that gravity gives over a spacing. A pool at rest that is 10 layers deep breathes with 0.05, and its particles
        // tremble with 0.04 (root mean square); a still one has less than 0.005 of either.
        private const double Jitter = 0.12, Drift = 0.08, Still = 0.01;

        // Of a spacing, for what goes slowly but goes on.
        private const double Gone = 0.15;

        // s.
        private const double LeastCalm = 0.6, DriftSeconds = 1.0;

        // Times in which gravity takes a particle over a spacing: how long velocities take to fade, and to be slow before sleep.
        private const double Fade = 1.0, Settling = 5.0;

        /// <param name="acceleration">That brings the liquid to rest, above 0 [m/s²].</param>
        /// <param name="spacing">Of the particles [m].</param>
        /// <param name="part">Of what is calm for water, 0 to 1: liquid that is meant to creep is calm only where it does not.</param>
        public SleepRule(double acceleration, double spacing, double part)
        {
            double speed = part * Math.Sqrt(acceleration * spacing), time = Math.Sqrt(spacing / acceleration);
            (JitterSpeed, DriftSpeed, StillSpeed) = ((float)(Jitter * speed), (float)(Drift * speed), (float)(Still * speed));
            (MostDrift, DriftTime) = ((float)(part * Gone * spacing), (float)DriftSeconds);
            (CalmTime, StillTime, FadeTime) = ((float)LeastCalm, (float)(Settling * time), (float)(Fade * time));
        }

        /// <summary>Root mean square of the speeds of a calm brick's particles, at most [m/s].</summary>
        public float JitterSpeed { get; }

        /// <summary>Speed of a calm brick as a whole, at most [m/s].</summary>
        public float DriftSpeed { get; }

        /// <summary>Root mean square of the speeds of a brick's particles that may fall asleep, at most [m/s].</summary>
        public float StillSpeed { get; }

        /// <summary>How far a calm brick goes in <see cref="DriftTime"/>, at most [m].</summary>
        public float MostDrift { get; }

        /// <summary>How long a brick remembers where it went [s].</summary>
        public float DriftTime { get; }

        /// <summary>How long a brick and those around it are calm before their particles are slowed [s].</summary>
        public float CalmTime { get; }

        /// <summary>How long they are still before they sleep [s].</summary>
        public float StillTime { get; }

        /// <summary>In which the velocities of what is to sleep fade by a factor e [s].</summary>
        public float FadeTime { get; }
    }
}
