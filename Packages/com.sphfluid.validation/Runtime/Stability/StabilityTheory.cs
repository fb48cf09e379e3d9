using System;

namespace SphFluid.Validation
{
    /// <summary>
    /// What the maps know of a method: the support that they are drawn at, its borders by linear theory on the simple cubic lattice, and
    /// what its constants mean. c is √k.
    /// </summary>
    public sealed class StabilityTheory
    {
        /// <summary>The thesis method: poly6 and spiky, ½ (p_i + p_j).</summary>
        public static readonly StabilityTheory Thesis = new StabilityTheory
        {
            SupportRatio = 2.0, WaveSpeedRatio = Math.Sqrt(0.5), AcousticBorder = 1.37, ViscousBorder = 0.125, HasAccelerationLimit = true,
        };

        /// <summary>The Standard method: Wendland's C2 for density and force, each over the lattice's moment, 0.976 at κ = 2.25.</summary>
        public static readonly StabilityTheory Standard = new StabilityTheory
        {
            SupportRatio = 2.25, WaveSpeedRatio = 1.0, AcousticBorder = 0.876, ViscousBorder = 0.0756,
        };

        /// <summary>
        /// The Robust method, to which no linear theory sets a border: its maps have the axes of the Standard method, and are to be
        /// compared with those.
        /// </summary>
        public static readonly StabilityTheory Robust = new StabilityTheory
        {
            SupportRatio = 2.25, WaveSpeedRatio = 1.0, AcousticBorder = 0.876, ViscousBorder = 0.0756,
        };

        private StabilityTheory()
        {
        }

        /// <summary>κ = R/dx of the maps.</summary>
        public double SupportRatio { get; private set; }

        /// <summary>Speed of waves over c.</summary>
        public double WaveSpeedRatio { get; private set; }

        /// <summary>dt·c/R at the border of stability.</summary>
        public double AcousticBorder { get; private set; }

        /// <summary>ν·dt/R² at the border of stability.</summary>
        public double ViscousBorder { get; private set; }

        /// <summary>Whether it has the emergency limit on accelerations, so that there are maps with it.</summary>
        public bool HasAccelerationLimit { get; private set; }

        /// <summary>What holds for a method; both forms of the thesis method have the same.</summary>
        public static StabilityTheory Of(CaseMethod method) =>
            method.Kind == FluidMethodKind.Standard ? Standard : method.Kind == FluidMethodKind.Robust ? Robust : Thesis;
    }
}
