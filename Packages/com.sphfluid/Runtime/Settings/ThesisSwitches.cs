using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// Where the thesis's text and the form of it that works part: each switch can be set alone, to see what the printed
    /// form does. Documentation~/printed-forms.md of com.sphfluid.validation shows it. Start from <see cref="Corrected"/>.
    /// </summary>
    [Serializable]
    public struct ThesisSwitches : IEquatable<ThesisSwitches>
    {
        /// <summary>True: a particle counts itself in its density, equation (11). Printed (6.3.1): off.</summary>
        [Tooltip(
            "A particle counts itself in its density, equation (11). Off: as 6.3.1 prints it; the liquid contracts, and a lone particle " +
            "has density 0.")]
        public bool SelfDensity;

        /// <summary>True: negative pressures act as zero. Printed, equation (10): off.</summary>
        [Tooltip("Negative pressures act as zero. Off: equation (10) as printed; the surface pulls itself into clumps.")]
        public bool PressureClamp;

        /// <summary>True: the ½ of equation (13), k = 2 c². False: the full gradient, k = c². Printed: on.</summary>
        [Tooltip(
            "The ½ of equation (13), which halves the pressure gradient; the stiffness is then doubled, k = 2 c². Off: the full " +
            "gradient, k = c².")]
        public bool PressureHalf;

        /// <summary>Limit on the fluid's own acceleration, 6.3.3 lines 04 to 06.</summary>
        [Tooltip("Emergency: the fluid's own acceleration is at most one spacing a step. As Printed: at most the fastest expected speed, " +
            "m/s taken for m/s²; the liquid cannot carry itself.")]
        public ThesisAccelerationLimit AccelerationLimit;

        /// <summary>True: acceleration = force × mass, as 6.3.3 line 03 prints it. False: f/ρ, equation (9).</summary>
        [Tooltip("Acceleration = force × mass, as 6.3.3 prints it. Off: force density over density, equation (9).")]
        public bool ForceTimesMass;

        /// <summary>True: the first step takes the velocities half a step back, equation (21). Printed (6.3.4): off.</summary>
        [Tooltip(
            "The first step takes the velocities half a step back, where leapfrog wants them, equation (21). Off: as 6.3.4 prints it; a " +
            "fall errs by ½ g t dt.")]
        public bool HalfKick;

        /// <summary>True: cells of 2h, of which 8 are searched, as 6.2 has it. False: cells of h, of which 27 are searched.</summary>
        [Tooltip(
            "Cells of 2h, of which the 8 at the particle's octant are searched, as 6.2 has it. Off: cells of h, all 27 around the " +
            "particle, in 9 rows. " +
            "Same neighbours, other cost. A change starts the liquid again.")]
        public bool OctantSearch;

        /// <summary>True: the sort of <c>ThesisSettings.FusedSort</c>. Printed, Appendix A: off.</summary>
        [Tooltip(
            "The sort keeps runs of 2,048 pairs in shared memory from level to level, in a third of the dispatches. Off: as Appendix A " +
            "has it. " +
            "Same order, less time.")]
        public bool FusedSort;

        /// <summary>The form that works: what the method <see cref="FluidMethodKind.Thesis"/> starts from.</summary>
        public static ThesisSwitches Corrected => new ThesisSwitches
        {
            SelfDensity = true,
            PressureClamp = true,
            PressureHalf = true,
            AccelerationLimit = ThesisAccelerationLimit.Emergency,
            HalfKick = true,
            OctantSearch = true,
        };

        /// <summary>The text as printed, as far as it can run: <see cref="FluidMethodKind.ThesisPrinted"/>.</summary>
        public static ThesisSwitches Printed => new ThesisSwitches
        {
            PressureHalf = true,
            AccelerationLimit = ThesisAccelerationLimit.AsPrinted,
            ForceTimesMass = true,
            OctantSearch = true,
        };

        internal readonly ThesisSwitches Limited()
        {
            ThesisSwitches limited = this;
            limited.AccelerationLimit = Limits.Known(AccelerationLimit);
            return limited;
        }

        internal readonly void Validate() => Require.Known(AccelerationLimit, nameof(AccelerationLimit));

        /// <inheritdoc/>
        public bool Equals(ThesisSwitches other) =>
            SelfDensity == other.SelfDensity && PressureClamp == other.PressureClamp && PressureHalf == other.PressureHalf &&
            AccelerationLimit == other.AccelerationLimit && ForceTimesMass == other.ForceTimesMass && HalfKick == other.HalfKick &&
            OctantSearch == other.OctantSearch && FusedSort == other.FusedSort;

        /// <inheritdoc/>
        public override bool Equals(object obj) => obj is ThesisSwitches other && Equals(other);

        /// <inheritdoc/>
        public override int GetHashCode() =>
            HashCode.Combine(SelfDensity, PressureClamp, PressureHalf, AccelerationLimit, ForceTimesMass, HalfKick,
                OctantSearch, FusedSort);
    }
}
