using System;
using System.Collections.Generic;

namespace SphFluid.Validation
{
    /// <summary>The five maps.</summary>
    public static class StabilityMaps
    {
        static readonly StabilityTheory thesis = StabilityTheory.Thesis, standard = StabilityTheory.Standard;

        // k_w dt² = 4 − 2 c_w dt with critical damping, c_w = 2 √k_w: √k_w dt = √8 − 2.
        static readonly double wallBorder = Math.Sqrt(8.0) - 2.0;

        const string WallTitle = "wall, k_w dt² = 4 − 2 c_w dt";

        /// <summary>M1 to M5.</summary>
        public static IReadOnlyList<StabilityMap> All { get; } = new[]
        {
            new StabilityMap("M1", "Column at rest", new StabilityAxis("dt·c/R", 0.05, 2.0), new StabilityAxis("c/√(gH)", 2.0, 40.0), StabilityScenes.Column,
                Sound(thesis, y => thesis.AcousticBorder), Sound(standard, y => standard.AcousticBorder),
                // The wall stops √(2gH) within dx/2: √k_w = 2 √(2gH)/dx.
                new StabilityBorder(thesis, WallTitle, y => wallBorder * y / (Math.Sqrt(8.0) * thesis.SupportRatio))),
            new StabilityMap("M2", "Periodic box, viscosity", new StabilityAxis("ν·dt/R²", 0.005, 0.3), new StabilityAxis("dt·c/R", 0.05, 2.0), StabilityScenes.ViscousBox,
                Viscosity(thesis), Viscosity(standard), SoundLevel(thesis), SoundLevel(standard)),
            new StabilityMap("M3", "Two blocks collide", new StabilityAxis("dt·v/dx", 0.05, 2.0), new StabilityAxis("c/v", 2.0, 40.0), StabilityScenes.Collision,
                Sound(thesis, y => thesis.AcousticBorder * thesis.SupportRatio / y), Sound(standard, y => standard.AcousticBorder * standard.SupportRatio / y)),
            new StabilityMap("M4", "Periodic box under pressure", new StabilityAxis("P/(ρc²)", -0.1, 0.3, false), new StabilityAxis("κ = R/dx", 1.7, 4.0, false),
                StabilityScenes.PressedBox),
            new StabilityMap("M5", "Spray hits a slab", new StabilityAxis("v·dt/dx", 0.05, 2.0), new StabilityAxis("thickness/dx", 0.1, 4.0), StabilityScenes.Spray,
                // The wall stops v within dx/2: √k_w = 2 v/dx.
                new StabilityBorder(thesis, WallTitle, y => 0.5 * wallBorder), Advised(thesis), Advised(standard)),
        };

        static StabilityBorder Sound(StabilityTheory theory, Func<double, double> x) => new StabilityBorder(theory, SoundTitle(theory), x);

        static StabilityBorder SoundLevel(StabilityTheory theory) => new StabilityBorder(theory, SoundTitle(theory), theory.AcousticBorder);

        static string SoundTitle(StabilityTheory theory) => FormattableString.Invariant($"sound, dt·c/R = {theory.AcousticBorder:G3}");

        static StabilityBorder Viscosity(StabilityTheory theory) =>
            new StabilityBorder(theory, FormattableString.Invariant($"viscosity, ν·dt/R² = {theory.ViscousBorder:G3}"), y => theory.ViscousBorder);

        static StabilityBorder Advised(StabilityTheory theory) =>
            new StabilityBorder(theory, FormattableString.Invariant($"advised, v·dt/dx = {TimeStepAdvice.SpeedLimit}"), y => TimeStepAdvice.SpeedLimit);
    }
}
