namespace SphFluid
{
    /// <summary>Where a simulation's time step comes from.</summary>
    public enum FluidTimeStepMode
    {
        /// <summary>
        /// By rule from spacing, stiffness and viscosity, stable up to the fastest expected speed: one length, or equal parts of each frame
        /// where the speed of sound follows the liquid (<see cref="FluidSoundSpeedMode"/>).
        /// </summary>
        Automatic = 0,

        /// <summary>A number of seconds given by the user.</summary>
        Fixed = 1,

        /// <summary>
        /// Equal parts of each frame, as few as are stable at the speed that was measured: liquid faster than expected takes more steps.
        /// </summary>
        Adaptive = 2,
    }
}
