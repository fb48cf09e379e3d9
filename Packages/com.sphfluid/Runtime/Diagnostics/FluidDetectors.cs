using System;
using System.Collections.Generic;

namespace SphFluid
{
    /// <summary>
    /// Names what goes wrong from a liquid's constants and its statistics over time. Pure: no GPU, no scene.
    /// Documentation~/diagnostics.md lists the limits. <see cref="FluidFailure.AsymmetricPairs"/> needs a search by brute force and is not
    /// among them.
    /// </summary>
    public sealed class FluidDetectors
    {
        private static readonly FluidDetector[] OfSettings =
        {
            StabilityDetectors.TimeStepTooLong, StabilityDetectors.ViscosityTooStiff, ModelDetectors.SelfTermMissing,
            ModelDetectors.TooLittleViscosity, ModelDetectors.NumericalViscosity,
        };

        private static readonly FluidDetector[] OfStatistics =
        {
            StabilityDetectors.NonFinite, StabilityDetectors.EnergyGrowth, StabilityDetectors.TimeStepTooLong,
            StabilityDetectors.ViscosityTooStiff, StabilityDetectors.Tunnelling, StabilityDetectors.ClampActs,
            ParticleDetectors.StaleGrid, ParticleDetectors.OverlappingStart, ParticleDetectors.CoincidentParticles,
            ParticleDetectors.TensileClumping,
            ParticleDetectors.Pairing, ParticleDetectors.Escaped, ParticleDetectors.WallStacking, ParticleDetectors.Overflow,
            ModelDetectors.SelfTermMissing, ModelDetectors.DensityDeficiency, ModelDetectors.Boiling, ModelDetectors.DeepTankLoss,
        };

        private readonly FluidEvidence evidence;
        private IReadOnlyList<FluidFinding> ofSettings;

        /// <summary>Detectors for a liquid.</summary>
        /// <param name="settings">Its constants and its method: some failures belong to one.</param>
        /// <param name="realViscosity">Kinematic viscosity of the liquid that is meant [m²/s]; NaN where it is not known.</param>
        public FluidDetectors(in FluidSolverSettings settings, double realViscosity = double.NaN)
        {
            evidence = new FluidEvidence(settings, realViscosity);
        }

        /// <summary>What the constants alone show, before the first step.</summary>
        /// <returns>The findings; empty when all is well.</returns>
        public IReadOnlyList<FluidFinding> Check() => ofSettings ??= Look(OfSettings, Array.Empty<FluidFinding>());

        /// <summary>Takes note of the statistics, oldest first.</summary>
        /// <param name="statistics">The liquid now. The first ones are what energies are compared with: measure at the start.</param>
        /// <param name="counters">The guards' counts now; what they gained since the last call counts.</param>
        /// <returns>What is wrong now, the findings of <see cref="Check"/> first; empty when all is well.</returns>
        public IReadOnlyList<FluidFinding> Update(in FluidStatistics statistics, in FluidCounters counters)
        {
            IReadOnlyList<FluidFinding> known = Check();
            evidence.AddStatistics(statistics, counters);
            return Look(OfStatistics, known);
        }

        /// <summary>
        /// The next statistics become what energies are compared with: call it when something gave the liquid energy that is no failure, a
        /// moved collider or a changed particle. Moving walls of the domain and gravity around a periodic axis are known to do work: energy
        /// growth is then not looked for.
        /// </summary>
        public void Rebase() => evidence.Rebase();

        /// <summary>Takes note of changed constants; a change of those that energies depend on is a <see cref="Rebase"/> too.</summary>
        /// <param name="settings">The constants now.</param>
        public void Apply(in FluidSolverSettings settings)
        {
            if (evidence.SetConstants(settings)) ofSettings = null;
        }

        private IReadOnlyList<FluidFinding> Look(FluidDetector[] detectors, IReadOnlyList<FluidFinding> known)
        {
            List<FluidFinding> found = null;
            foreach (FluidDetector detector in detectors)
            {
                if (!(detector(evidence) is FluidFinding finding) || Has(found ?? known, finding.Failure)) continue;
                found ??= new List<FluidFinding>(known);
                found.Add(finding);
            }
            return found ?? known;
        }

        private static bool Has(IReadOnlyList<FluidFinding> findings, FluidFailure failure)
        {
            for (int i = 0; i < findings.Count; i++)
                if (findings[i].Failure == failure) return true;
            return false;
        }
    }

    /// <summary>Looks at the evidence for one failure; null when there is none.</summary>
    internal delegate FluidFinding? FluidDetector(FluidEvidence evidence);
}
