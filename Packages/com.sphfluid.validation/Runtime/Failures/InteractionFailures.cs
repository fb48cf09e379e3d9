using System;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>What pressure does wrong between particles: suction, wide kernels, two kernels.</summary>
    internal static class InteractionFailures
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
        /// A column between walls at κ = 4: next to them particles find half the density and share places until they find it all. Cured: κ
        /// = 2.
        /// </summary>
        public static FailureExperiment Pairing()
        {
            return new FailureExperiment("pairing", FluidFailure.Pairing, At(4f), At(2f),
                "share of particles with a neighbour nearer than dx/2", Clumped);

            FailureRun At(float support)
            {
                FailureRun run = FailureBlocks.Column(new Vector3Int(6, 10, 6), 9.81f, 25.0, FluidAxes.None, support);
                run.Steps = 250;
                return run;
            }
        }

        /// <summary>
        /// The same without walls: pairs a fifth of a spacing apart in a periodic box at κ = 4, compressed by 2 %. They part.
        /// </summary>
        public static FailureRun PairsInTheBulk()
        {
            // Two particles of half the mass a place: the same density.
            float dx = FailureBlocks.Spacing, place = dx * Mathf.Pow(2f, 1f / 3f);
            var counts = new Vector3Int(10, 10, 10);
            Vector3 domain = place * (Vector3)counts;
            var run = new FailureRun { Settings = FailureBlocks.Settings(domain, 4f, FluidAxes.All), Steps = 12, Samples = 1 };
            run.Settings.ParticleMass *= 1.02f;
            FluidParticle[] first = FailureBlocks.Lattice(counts, place, -0.5f * domain, 0.0, 0.5f * domain);
            Vector3 beside = 0.2f * dx * new Vector3(0.36f, 0.48f, 0.8f);
            run.Start = FailureBlocks.Join(first, Array.ConvertAll(first, p => new FluidParticle(p.Position + beside, Vector3.zero, 0)));
            return run;
        }

        /// <summary>A lattice with a jitter of 1e-4 dx boils without viscosity: research's box, t = 200 R/c, c = √k.</summary>
        public static FailureExperiment KernelMismatch()
        {
            FailureRun failing = FailureBlocks.PeriodicBox(new Vector3Int(8, 8, 8), 2f, 1e-4);
            failing.Settings.PressureClamp = false;
            FailureBlocks.SetKinematic(ref failing.Settings, 0.0);
            FailureBlocks.SetCourant(ref failing.Settings, 0.4 * ThesisRules.AcousticBorder);
            failing.Steps = (int)Math.Round(200.0 / (0.4 * ThesisRules.AcousticBorder));
            FluidSolverSettings viscous = failing.Settings;
            FailureBlocks.SetKinematic(ref viscous, 0.02 * Math.Sqrt(viscous.Own<ThesisSettings>().Stiffness) * viscous.SupportRadius);
            return new FailureExperiment("kernel-mismatch", FluidFailure.KernelMismatch, failing, failing.With(viscous),
                "v_rms/√k at t = 200 R/√k", r => RmsSpeed(r) / Math.Sqrt(r.Settings.Own<ThesisSettings>().Stiffness));
        }

        private static double Clumped(FailureResult result) => result.EndStatistics.Clumped / (double)result.Run.Start.Length;

        private static double RmsSpeed(FailureResult result) => result.EndStatistics.RmsSpeed(result.Settings.ParticleMass);
    }
}
