namespace SphFluid
{
    /// <summary>
    /// One step of leapfrog: positions live at its ends, velocities in the middle. Steps of unequal lengths stay second order
    /// where the kick takes the velocities from the middle of the last step to the middle of this one.
    /// </summary>
    internal readonly struct FluidStep
    {
        /// <summary>A step.</summary>
        /// <param name="length">Its length [s].</param>
        /// <param name="previous">Length of the step before [s]; its own for the first.</param>
        /// <param name="isFirst">True where the particles' velocities are still those of the start.</param>
        /// <param name="keepsOrder">True where another step follows for which the order of particles found for this one may serve.</param>
        public FluidStep(float length, float previous, bool isFirst, bool keepsOrder = false)
        {
            KeepsOrder = keepsOrder;
            Length = length;
            Previous = previous;
            IsFirst = isFirst;
        }

        /// <summary>Length of the step [s]: how far the positions go.</summary>
        public float Length { get; }

        /// <summary>Length of the step before [s].</summary>
        public float Previous { get; }

        /// <summary>True where the particles' velocities are still those of the start.</summary>
        public bool IsFirst { get; }

        /// <summary>True where another step follows for which the order of particles found for this one may serve.</summary>
        public bool KeepsOrder { get; }

        /// <summary>How far the velocities go [s]: the mean of both lengths.</summary>
        public float Kick => 0.5f * (Previous + Length);

        /// <summary>Part of the kick up to the time of the positions and forces: a half where both lengths are equal.</summary>
        public float KickPart => Previous / (Previous + Length);
    }
}
