namespace SphFluid.Validation
{
    /// <summary>What the picture of a <see cref="SwitchExperiment"/> shows by colour, from blue to red.</summary>
    public enum SwitchColor
    {
        /// <summary>Density, from ρ0 and below to 1.3 ρ0.</summary>
        Density = 0,

        /// <summary>Pressure as equation (10) gives it, from 0 to twice ρ0 g times the height of the box.</summary>
        Pressure = 1,

        /// <summary>Speed, from 0 to 0.3 m/s.</summary>
        Speed = 2,
    }
}
