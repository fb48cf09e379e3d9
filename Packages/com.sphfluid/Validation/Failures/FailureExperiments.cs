using System.Collections.Generic;

namespace SphFluid.Validation
{
    /// <summary>One experiment for each failure mode of Documentation~/failure-modes.md, in its order.</summary>
    public static class FailureExperiments
    {
        /// <summary>All.</summary>
        public static IReadOnlyList<FailureExperiment> All() => new[]
        {
            InteractionFailures.TensileClumping(), InteractionFailures.Pairing(), InteractionFailures.KernelMismatch(), DensityFailures.Deficiency(),
            DensityFailures.SelfTerm(), DensityFailures.Coincident(), StepFailures.TimeStep(), StepFailures.Viscosity(),
            StepFailures.NumericalViscosity(), DensityFailures.DeepTank(), WallFailures.Tunnelling(), WallFailures.Stacking(),
            GuardFailures.Clamp(), GuardFailures.Overflow(), DensityFailures.Overlap(), NeighbourFailures.AsymmetricPairs(), NeighbourFailures.StaleGrid(),
        };
    }
}
