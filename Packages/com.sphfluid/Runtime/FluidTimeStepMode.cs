namespace SphFluid
{
    /// <summary>Where a simulation's time step comes from.</summary>
    public enum FluidTimeStepMode
    {
        /// <summary>By rule from spacing, stiffness and viscosity: always stable.</summary>
        Automatic = 0,

        /// <summary>A number of seconds given by the user.</summary>
        Fixed = 1,
    }
}
