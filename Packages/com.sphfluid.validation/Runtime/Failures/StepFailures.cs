using System;
using System.Linq;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Steps that are too long, and viscosity that is too much or the method's own.</summary>
    internal static class StepFailures
    {
        // Compressed a little, so that the clamp does not act and the lattice is that of the linear theory.
        private const float Compression = 0.02f;

        /// <summary>A jittered lattice at dt √k/R; the border is 1.35 to 1.40.</summary>
        public static FailureExperiment TimeStep(double failing = 1.45, double cured = 1.25)
        {
            return new FailureExperiment("time-step", FluidFailure.TimeStepTooLong, At(failing), At(cured),
                "v_rms/c after 150 steps", r => r.EndStatistics.RmsSpeed(r.Settings.ParticleMass) / r.Settings.SoundSpeed);

            FailureRun At(double courant)
            {
                FailureRun run = FailureBlocks.PeriodicBox(8 * Vector3Int.one, 2f, 1e-4);
                run.Settings.ParticleMass *= 1f + Compression;
                FailureBlocks.SetCourant(ref run.Settings, courant);
                run.Steps = 150;
                return run;
            }
        }

        /// <summary>
        /// Noise of velocities on a lattice without pressure at ν dt/R²; the border is 0.115 to 0.131, at κ = 2 near 0.128.
        /// </summary>
        public static FailureExperiment Viscosity(double failing = 0.14, double cured = 0.06)
        {
            return new FailureExperiment("viscosity", FluidFailure.ViscosityTooStiff, At(failing), At(cured),
                "growth of v_rms over the last 50 of 100 steps",
                r => RmsSpeed(r, r.EndStatistics) / RmsSpeed(r, r.Statistics[r.Statistics.Count / 2]));

            FailureRun At(double ratio)
            {
                FailureRun run = FailureBlocks.PeriodicBox(8 * Vector3Int.one, 2f, 0.0);
                run.Settings = run.Settings.WithOwn((ref ThesisSettings own) => own.Stiffness = 1e-6f);
                var random = new System.Random(3);
                float Noise() => 1e-4f * (float)(random.NextDouble() - 0.5);
                run.Start = FailureBlocks.Moving(run.Start, _ => new Vector3(Noise(), Noise(), Noise()));
                run.Settings.TimeStep = 0.01f;
                FailureBlocks.SetKinematic(ref run.Settings,
                    ratio * run.Settings.SupportRadius * run.Settings.SupportRadius / run.Settings.TimeStep);
                run.Steps = 100;
                return run;
            }
        }

        /// <summary>
        /// A shear wave in water: its viscosity is the method's α c R, by rule, so it goes with the spacing. Cured: a liquid as thick as
        /// the method needs, the same at every spacing.
        /// </summary>
        /// <param name="cells">Spacings to the wave's length of 1.2 m.</param>
        public static FailureExperiment NumericalViscosity(int cells = 12)
        {
            const double water = 1e-6, thick = 0.04;
            return new FailureExperiment("numerical-viscosity", FluidFailure.NumericalViscosity, Liquid(water), Liquid(thick),
                "viscosity of the decay over the liquid's own", r => DecayViscosity(r) / r.Run.RealViscosity);

            FailureRun Liquid(double viscosity)
            {
                float dx = 1.2f / cells;
                FailureRun run = FailureBlocks.PeriodicBox(new Vector3Int(6, cells, 6), 2f, 1e-3, dx);
                run.Settings.ParticleMass *= 1f + Compression;
                run.RealViscosity = viscosity;
                double acting = Math.Max(viscosity, run.Settings.Viscosity / (double)run.Settings.RestDensity);
                FailureBlocks.SetKinematic(ref run.Settings, acting);
                double wave = 2.0 * Math.PI / run.Settings.DomainSize.y;
                run.Start = FailureBlocks.Moving(run.Start, p => new Vector3(0.5f * Mathf.Sin((float)(wave * p.y)), 0f, 0f));
                run.Steps = (int)Math.Round(0.7 / (acting * wave * wave) / run.Settings.TimeStep);
                run.Samples = 10;
                return run;
            }
        }

        /// <summary>ν of A(t) = A0 exp(−ν k² t) between the first sample after the start and the last [m²/s].</summary>
        public static double DecayViscosity(FailureResult result)
        {
            double wave = 2.0 * Math.PI / result.Settings.DomainSize.y;
            double time = result.EndStatistics.Time - result.Statistics[1].Time;
            return Math.Log(Amplitude(result.States[1], wave) / Amplitude(result.End, wave)) / (wave * wave * time);
        }

        private static double Amplitude(FluidSnapshot state, double wave) =>
            2.0 * Enumerable.Range(0, state.Count).Average(i => state.Velocities[i].x * Math.Sin(wave * state.LocalPositions[i].y));

        private static double RmsSpeed(FailureResult result, in FluidStatistics statistics) =>
            statistics.RmsSpeed(result.Settings.ParticleMass);
    }
}
