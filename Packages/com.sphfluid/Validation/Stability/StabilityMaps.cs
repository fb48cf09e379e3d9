using System;
using System.Collections.Generic;

namespace SphFluid.Validation
{
    /// <summary>The five maps.</summary>
    public static class StabilityMaps
    {
        /// <summary>dt·c/R at the border for the thesis's force, κ = 2.</summary>
        public const double ThesisBorder = 1.37;

        /// <summary>dt·c/R at the border for one-kernel methods.</summary>
        public const double StandardBorder = 0.9;

        /// <summary>ν·dt/R² at the border for the thesis's viscosity, κ = 2.</summary>
        public const double ViscousBorder = 0.125;

        // k_w dt² = 4 − 2 c_w dt with critical damping, c_w = 2 √k_w: √k_w dt = √8 − 2.
        static readonly double wallBorder = Math.Sqrt(8.0) - 2.0;

        /// <summary>M1 to M5.</summary>
        public static IReadOnlyList<StabilityMap> All { get; } = new[]
        {
            new StabilityMap("M1", "Column at rest", new StabilityAxis("dt·c/R", 0.05, 2.0), new StabilityAxis("c/√(gH)", 2.0, 40.0),
                StabilityScenes.Column, new StabilityBorder("thesis, dt·c/R = 1.37", y => ThesisBorder), new StabilityBorder("one kernel, dt·c/R = 0.9", y => StandardBorder),
                // The wall stops √(2gH) within dx/2: √k_w = 2 √(2gH)/dx.
                new StabilityBorder("wall, k_w dt² = 4 − 2 c_w dt", y => wallBorder * y / (Math.Sqrt(8.0) * StabilityConstants.SupportRatio))),
            new StabilityMap("M2", "Periodic box, viscosity", new StabilityAxis("ν·dt/R²", 0.005, 0.3), new StabilityAxis("dt·c/R", 0.05, 2.0),
                StabilityScenes.ViscousBox, new StabilityBorder("viscosity, ν·dt/R² = 0.125", y => ViscousBorder),
                new StabilityBorder("sound, dt·c/R = 1.37", ThesisBorder)),
            new StabilityMap("M3", "Two blocks collide", new StabilityAxis("dt·v/dx", 0.05, 2.0), new StabilityAxis("c/v", 2.0, 40.0),
                StabilityScenes.Collision, new StabilityBorder("thesis, dt·c/R = 1.37", y => ThesisBorder * StabilityConstants.SupportRatio / y),
                new StabilityBorder("one kernel, dt·c/R = 0.9", y => StandardBorder * StabilityConstants.SupportRatio / y)),
            new StabilityMap("M4", "Periodic box under pressure", new StabilityAxis("P/(ρc²)", -0.1, 0.3, false), new StabilityAxis("κ = R/dx", 1.7, 4.0, false),
                StabilityScenes.PressedBox),
            new StabilityMap("M5", "Spray hits a slab", new StabilityAxis("v·dt/dx", 0.05, 2.0), new StabilityAxis("thickness/dx", 0.1, 4.0),
                // The wall stops v within dx/2: √k_w = 2 v/dx.
                StabilityScenes.Spray, new StabilityBorder("wall, k_w dt² = 4 − 2 c_w dt", y => 0.5 * wallBorder), new StabilityBorder("advised, v·dt/dx = 0.4", y => 0.4)),
        };
    }
}
