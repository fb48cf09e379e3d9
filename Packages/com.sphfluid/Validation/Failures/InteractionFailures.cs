using System;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>What pressure does wrong between particles: suction, wide kernels, two kernels.</summary>
    static class InteractionFailures
    {
        /// <summary>Stretched by 5 % in a periodic box, P/ρc² = −0.05: suction draws the lattice into clumps.</summary>
        public static FailureExperiment TensileClumping()
        {
            FailureRun cured = FailureBlocks.PeriodicBox(new Vector3Int(8, 8, 8), 2f, 1e-3);
            cured.Settings.ParticleMass *= 0.95f;
            cured.Steps = 200;
            FluidSolverSettings suction = cured.Settings;
            suction.PressureClamp = false;
            return new FailureExperiment("tensile-clumping", FluidFailure.TensileClumping, cured.With(suction), cured,
                "share of particles with a neighbour nearer than dx/2", Clumped);
        }

        /// <summary>
        /// κ = 4, each particle of a lattice twice, a tenth of a spacing apart: are pairs stable? Cured: a lattice without.
        /// </summary>
        public static FailureExperiment Pairing()
        {
            // Two particles of half the mass a place: the same density.
            float dx = FailureBlocks.Spacing, place = dx * Mathf.Pow(2f, 1f / 3f);
            var counts = new Vector3Int(10, 10, 10);
            Vector3 domain = place * (Vector3)counts;
            FluidSolverSettings settings = FailureBlocks.Settings(domain, 4f, FluidAxes.All);
            settings.ParticleMass *= 1.02f;
            FluidParticle[] first = FailureBlocks.Lattice(counts, place, -0.5f * domain, 0.0, 0.5f * domain);
            FluidParticle[] second = System.Array.ConvertAll(first, p => new FluidParticle(p.Position + 0.2f * dx * new Vector3(0.36f, 0.48f, 0.8f), Vector3.zero, 0));
            var paired = new FailureRun { Settings = settings, Start = FailureBlocks.Join(first, second), Steps = 200 };
            FailureRun lattice = FailureBlocks.PeriodicBox(12 * Vector3Int.one, 4f, 0.1);
            lattice.Settings.ParticleMass *= 1.02f;
            lattice.Steps = 200;
            return new FailureExperiment("pairing", FluidFailure.Pairing, paired, lattice, "share of particles with a neighbour nearer than dx/2 at the end", Clumped);
        }

        /// <summary>A lattice with a jitter of 1e-4 dx boils without viscosity: research's box, t = 200 R/c, c = √k.</summary>
        public static FailureExperiment KernelMismatch()
        {
            FailureRun failing = FailureBlocks.PeriodicBox(new Vector3Int(8, 8, 8), 2f, 1e-4);
            failing.Settings.PressureClamp = false;
            FailureBlocks.SetKinematic(ref failing.Settings, 0.0);
            FailureBlocks.SetCourant(ref failing.Settings, 0.4 * TimeStepAdvice.AcousticBorder);
            failing.Steps = (int)Math.Round(200.0 / (0.4 * TimeStepAdvice.AcousticBorder));
            FluidSolverSettings viscous = failing.Settings;
            FailureBlocks.SetKinematic(ref viscous, 0.02 * Math.Sqrt(viscous.Stiffness) * viscous.SupportRadius);
            return new FailureExperiment("kernel-mismatch", FluidFailure.KernelMismatch, failing, failing.With(viscous),
                "v_rms/√k at t = 200 R/√k", r => RmsSpeed(r) / Math.Sqrt(r.Settings.Stiffness));
        }

        static double Clumped(FailureResult result) => result.EndVitals.Clumped / (double)result.Run.Start.Length;

        static double RmsSpeed(FailureResult result) => result.EndVitals.RmsSpeed(result.Settings.ParticleMass);
    }
}
