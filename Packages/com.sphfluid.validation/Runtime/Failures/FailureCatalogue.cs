using System.Collections.Generic;

namespace SphFluid.Validation
{
    /// <summary>One experiment for each failure mode of Documentation~/failure-modes.md, in its order.</summary>
    public static class FailureCatalogue
    {
        /// <summary>All.</summary>
        public static IReadOnlyList<FailureExperiment> All() => new[]
        {
            InteractionFailures.TensileClumping(), InteractionFailures.Pairing(), InteractionFailures.KernelMismatch(),
            DensityFailures.Deficiency(),
            DensityFailures.SelfTerm(), DensityFailures.Coincident(), StepFailures.TimeStep(), StepFailures.Viscosity(),
            StepFailures.NumericalViscosity(), DensityFailures.DeepTank(), WallFailures.Tunnelling(), WallFailures.Stacking(),
            GuardFailures.Clamp(), GuardFailures.Overflow(), DensityFailures.Overlap(), NeighbourFailures.AsymmetricPairs(),
            NeighbourFailures.StaleGrid(),
        };

        /// <summary>The experiment of a name.</summary>
        /// <param name="name">Its name, for instance "self-term".</param>
        /// <exception cref="System.ArgumentException">There is none.</exception>
        public static FailureExperiment Find(string name)
        {
            foreach (FailureExperiment experiment in All())
            {
                if (experiment.Name == name) return experiment;
            }
            throw new System.ArgumentException($"There is no failure experiment '{name}'.", nameof(name));
        }
    }
}
