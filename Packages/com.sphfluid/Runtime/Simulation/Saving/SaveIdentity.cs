using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>What a liquid and a simulation that it goes on in must have in common.</summary>
    internal struct SaveIdentity
    {
        public FluidMethodKind Method;
        public Vector3 DomainSize;
        public float Spacing;
        public float SupportRatio;
        public FluidAxes Periodic;

        /// <summary>That of a simulation.</summary>
        public static SaveIdentity Create(in FluidSpec spec) => new SaveIdentity
        {
            Method = spec.Method,
            DomainSize = spec.DomainSize,
            Spacing = spec.Spacing,
            SupportRatio = spec.Profile.Rules.SupportRatio,
            Periodic = spec.Boundaries.Periodic,
        };

        /// <summary>The first difference as a sentence; null where there is none.</summary>
        /// <param name="here">What the simulation has.</param>
        /// <param name="cure">What to set.</param>
        public readonly string Difference(in SaveIdentity here, out string cure)
        {
            (string setting, string saved, string present) =
                Method != here.Method ? ("Method", $"{Method}", $"{here.Method}") :
                !AffineMath.Same(DomainSize, here.DomainSize)
                ? ("Domain Size", FluidMessage.Lengths(DomainSize) + " m", FluidMessage.Lengths(here.DomainSize) + " m") :
                !Spacing.Equals(here.Spacing) ? ("Particle Spacing", Metres(Spacing), Metres(here.Spacing)) :
                !SupportRatio.Equals(here.SupportRatio) ? ("the profile's Support Ratio", Number(SupportRatio), Number(here.SupportRatio)) :
                Periodic != here.Periodic ? ("the periodic axes", $"{Periodic}", $"{here.Periodic}") : default;
            cure = setting == null ? "" : $"Set {setting} to {saved}, or restore a save of this simulation.";
            return setting == null ? null : $"The save is of a liquid with {saved} for {setting}, and this simulation has {present}.";
        }

        private static string Metres(float value) => Number(value) + " m";

        private static string Number(float value) => FormattableString.Invariant($"{value:R}");
    }
}
