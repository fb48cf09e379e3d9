namespace SphFluid
{
    /// <summary>What a sensor reads.</summary>
    public enum FluidSensorKind
    {
        /// <summary>Density at the sensor over the rest density: 1 within the liquid, 0.5 at its surface, 0 outside.</summary>
        Wetness,

        /// <summary>Speed of the liquid at the sensor [m/s]; 0 where it is dry.</summary>
        Speed,

        /// <summary>Pressure at the sensor [Pa]. Noisy: average it.</summary>
        Pressure,

        /// <summary>Height of the surface above the sensor along its up axis [m].</summary>
        Level,

        /// <summary>Part of a box about the sensor that holds liquid, 0 to 1.</summary>
        FillLevel,

        /// <summary>
        /// Volume a second that goes through a rectangle about the sensor along its forward axis, less what goes against it [m³/s]. Average
        /// it.
        /// </summary>
        Flow,
    }
}
