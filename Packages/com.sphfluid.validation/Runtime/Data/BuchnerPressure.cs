namespace SphFluid.Validation
{
    /// <summary>
    /// Pressure on the wall that a dam break hits: B. Buchner 2002, Green Water on Ship-type Offshore Structures, thesis, Delft University
    /// of Technology, as TrixiParticles.jl read it off the figure (validation/dam_break_2d/exp_pressure_sensor_P1.csv; MIT licence), up to
    /// the return of the water that ran up the wall. Water of 1.2 × 0.6 m, wall at 3.22 m, a gauge of 90 mm in diameter whose middle is 160
    /// mm above the floor.
    /// </summary>
    public static class BuchnerPressure
    {
        /// <summary>Height of the water [m].</summary>
        public const double WaterHeight = 0.6;

        /// <summary>Distance of the wall from the closed end [m].</summary>
        public const double TankLength = 3.22;

        /// <summary>Height of the gauge's middle above the floor [m], and its diameter.</summary>
        public const double GaugeHeight = 0.16, GaugeDiameter = 0.09;

        /// <summary>t √(g/H).</summary>
        public static readonly double[] Times =
        {
            2.025, 2.063, 2.124, 2.168, 2.250, 2.272, 2.426, 2.473, 2.491, 2.553, 2.616, 2.623, 2.650, 2.672, 2.689, 2.774, 2.835, 2.903,
            2.961, 3.022,
            3.025, 3.132, 3.193, 3.231, 3.368, 3.520, 3.679, 3.905, 4.060, 4.223, 4.355, 4.453, 4.570, 4.720, 4.817, 4.917, 5.038,
            5.159, 5.304,
        };

        /// <summary>p/(ρ g H) at those times.</summary>
        public static readonly double[] Pressures =
        {
            -0.018, 0.021, -0.022, 0.011, -0.020, 0.010, -0.015, 0.077, 0.154, 0.265, 0.371, 0.463, 0.562, 0.605, 0.662, 0.687, 0.672,
            0.661, 0.646, 0.643,
            0.601, 0.579, 0.564, 0.546, 0.541, 0.545, 0.541, 0.544, 0.556, 0.558, 0.555, 0.551, 0.543, 0.538, 0.517, 0.513, 0.514,
            0.514, 0.526,
        };
    }
}
