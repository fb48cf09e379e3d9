using System;

namespace SphFluid
{
    /// <summary>
    /// Finds out when a liquid rests. It rests when for longer than it takes to swing once all but a hundredth of its particles were slow,
    /// and none went anywhere: a wave at its turning point moves again within the time, and liquid that creeps or falls leaves its place.
    /// What is fast and stays where it is trembles between walls, in creases where it is jammed.
    /// </summary>
    internal sealed class SleepWatch
    {
        // Over √(g dx).
        private const double QuietSpeed = 0.3;

        // Over dx, for half of the particles, for all but a hundredth, and for all. Half of a pool at rest stays where it is for ever,
        // while here and there a few find a better place: in 2 s 0.05, 0.4 and 1 dx, of which neighbours share 0.08. What flows takes all
        // along.
        private const double HalfDistance = 0.15;
        private const double BulkDistance = 0.6;
        private const double LongestDistance = 1.5;

        // ν over c R by rule: below it motion that is left is noise, above it the liquid is meant to creep.
        private const double ThinViscosity = 0.001;

        // Over the longest period, and s.
        private const double Periods = 1.25;
        private const double LeastTime = 2.0;

        private double speedLimit, halfLimit, bulkLimit, farthestLimit, holdTime;
        private double quiet;
        private int kept;

        /// <summary>A watch for a liquid.</summary>
        /// <param name="settings">Its constants.</param>
        /// <param name="depth">Its depth at rest [m].</param>
        public SleepWatch(in FluidSolverSettings settings, double depth) => Configure(settings, depth);

        /// <summary>Whether the liquid rests.</summary>
        public bool IsAsleep { get; private set; }

        /// <summary>
        /// Takes over changed constants. Without any force there is nothing that brings liquid to rest: it is never asleep.
        /// </summary>
        public void Configure(in FluidSolverSettings settings, double depth)
        {
            double acceleration = LiquidPotential.Acceleration(settings);
            speedLimit = QuietSpeed * Math.Sqrt(acceleration * settings.Spacing);
            double thin = Thinness(settings);
            halfLimit = HalfDistance * thin * settings.Spacing;
            bulkLimit = BulkDistance * thin * settings.Spacing;
            farthestLimit = LongestDistance * thin * settings.Spacing;
            holdTime = Math.Max(LeastTime, Periods * LiquidPotential.LongestPeriod(settings, depth));
        }

        /// <summary>1 of liquid that is as thin as the method can have it; less of one that is meant to creep, in proportion.</summary>
        public static double Thinness(in FluidSolverSettings settings)
        {
            double viscosity = settings.Viscosity / settings.RestDensity;
            return Math.Min(1.0, ThinViscosity * settings.SoundSpeed * settings.SupportRadius / Math.Max(viscosity, 1e-12));
        }

        /// <summary>Something touched the liquid.</summary>
        public void Wake()
        {
            IsAsleep = false;
            quiet = 0.0;
            kept = 0;
        }

        /// <summary>How long no particle has been fast or gone anywhere [s]; for saves.</summary>
        internal (double quiet, bool watches, bool sleeps) Progress => (quiet, kept != 0, IsAsleep);

        /// <summary>Goes on from a save; the distances that particles go are measured from there on.</summary>
        /// <param name="progress">As of the save.</param>
        /// <param name="keepPlaces">Keeps the particles' places and gives that keeping's number.</param>
        internal void Continue((double quiet, bool watches, bool sleeps) progress, Func<int> keepPlaces)
        {
            (quiet, IsAsleep) = (progress.quiet, progress.sleeps);
            kept = progress.watches ? keepPlaces() : 0;
        }

        /// <summary>Takes note of a frame with steps.</summary>
        /// <param name="sample">The liquid as it was some frames ago.</param>
        /// <param name="time">The frame's time [s].</param>
        /// <param name="keepPlaces">Keeps the particles' places of this frame and gives that keeping's number.</param>
        /// <param name="forgetPlaces">Ends the measuring of distances.</param>
        public void AddSample(in SpeedSample sample, double time, Func<int> keepPlaces, Action forgetPlaces)
        {
            if (!(sample.Bulk < speedLimit) || float.IsPositiveInfinity(sample.Present))
            {
                if (kept != 0) forgetPlaces();
                quiet = 0.0;
                kept = 0;
            }
            else if (kept == 0 || sample.Kept == kept && !IsInPlace(sample))
            {
                quiet = 0.0;
                kept = keepPlaces();
            }
            else if (sample.Kept == kept)
            {
                quiet += time;
                IsAsleep = quiet >= holdTime;
            }
        }

        private bool IsInPlace(in SpeedSample sample) =>
            sample.HalfDistance < halfLimit && sample.Distance < bulkLimit && sample.Farthest < farthestLimit;
    }
}
