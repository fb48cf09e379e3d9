namespace SphFluid
{
    /// <summary>What a probe reads.</summary>
    public enum FluidProbeKind
    {
        /// <summary>Pressure on a wall [Pa]: the force of the liquid on a rectangle of the nearest wall, over its area.</summary>
        WallPressure,

        /// <summary>Velocity of the liquid at the probe [m/s], in the world.</summary>
        Velocity,

        /// <summary>Density of the liquid at the probe [kg/m³].</summary>
        Density,

        /// <summary>
        /// Mean pressure of the particles around the probe [Pa]. Noisy, and not what a wall feels: average it, and use it away from walls.
        /// </summary>
        LiquidPressure,
    }
}
