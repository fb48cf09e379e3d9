using System;

namespace SphFluid
{
    /// <summary>Constants and time steps by rule, by the method that they are for.</summary>
    public static class FluidRules
    {
        /// <summary>Constants by rule from spacing, depth and speed.</summary>
        /// <param name="input">What the rules start from.</param>
        /// <returns>The settings.</returns>
        /// <exception cref="ArgumentException">An input is out of range, or there is no such method.</exception>
        public static FluidSolverSettings Derive(in FluidRuleInput input)
        {
            FluidMethod method = FluidMethods.Get(input.Method);
            input.Validate();
            return method.Derive(input);
        }

        /// <summary>The largest stable time step of a liquid, and what limits it.</summary>
        /// <param name="settings">Its constants.</param>
        /// <param name="maxSpeed">Its fastest speed now [m/s].</param>
        /// <returns>The limits.</returns>
        /// <exception cref="ArgumentOutOfRangeException">The speed is negative or not finite.</exception>
        public static TimeStepAdvice Advise(in FluidSolverSettings settings, double maxSpeed)
        {
            if (!(maxSpeed >= 0.0) || double.IsInfinity(maxSpeed))
            {
                throw new ArgumentOutOfRangeException(nameof(maxSpeed), maxSpeed, "The fastest speed must be zero or more, and finite.");
            }

            return FluidMethods.Get(settings.Method).Advise(settings, maxSpeed);
        }

        /// <summary>
        /// The speed of sound that a liquid has in steps of a length: less than that of its settings with the method Robust, whose
        /// iterations are few.
        /// </summary>
        /// <param name="settings">Its constants.</param>
        /// <param name="timeStep">Length of a step [s].</param>
        /// <param name="maxSpeed">Its fastest speed [m/s].</param>
        /// <returns>Speed of sound c [m/s]; the liquid's weight compresses it by g D/c² at a depth D.</returns>
        /// <exception cref="ArgumentException">The step is not positive, or the speed is negative or not finite.</exception>
        public static double EffectiveSoundSpeed(in FluidSolverSettings settings, double timeStep, double maxSpeed) =>
            FluidMethods.Get(settings.Method)
                .EffectiveSoundSpeed(settings, Require.Positive(timeStep, nameof(timeStep)),
                    Require.NotNegative(maxSpeed, nameof(maxSpeed)));

        /// <summary>
        /// The viscosity that acts in steps of a length: with the method Robust, which has no limit of its steps, no more than they hold.
        /// </summary>
        /// <param name="settings">Its constants.</param>
        /// <param name="timeStep">Length of a step [s].</param>
        /// <returns>Kinematic viscosity ν [m²/s].</returns>
        /// <exception cref="ArgumentException">The step is not positive.</exception>
        public static double ActingViscosity(in FluidSolverSettings settings, double timeStep) =>
            FluidMethods.Get(settings.Method).ActingViscosity(settings, Require.Positive(timeStep, nameof(timeStep)));
    }
}
