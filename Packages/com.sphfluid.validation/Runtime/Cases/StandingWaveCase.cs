using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// A standing wave of length 2 and amplitude 0.05 on a liquid of depth 1, g = 1, ν = 0.004 (Re = 250), after AQUAgpusph's
    /// standing wave (Souto-Iglesias and others). Periodic along x and z: the floor is the only wall, and it has no friction.
    /// <para>
    /// Two things stand between the set and the measured viscosity. A force µ∇²v by pairs, as Müller's, dissipates µ ∫|∇v|²; a
    /// Newtonian liquid with a stress-free surface dissipates 2µ ∫ e:e, which is twice as much where the flow has no vorticity:
    /// of the set viscosity half acts. And particles that leave their lattice stir up vorticity, which damps on top (Colagrossi,
    /// Souto-Iglesias, Antuono and Marrone, Phys. Rev. E 87, 2013).
    /// </para>
    /// </summary>
    public sealed class StandingWaveCase : ValidationCase
    {
        private const double Length = 2.0, Depth = 1.0, Amplitude = 0.05, Gravity = 1.0, Viscosity = 0.004;
        private const double WaveNumber = 2.0 * Math.PI / Length;
        private const double SamplesPerPeriod = 32.0;

        // The start sinks by about a spacing, as the method has too little density at the surface and the floor. Meanwhile the
        // liquid falls and the wave waits: the first half period is not fitted.
        private const double FitFrom = 0.5, Lasts = 2.5; // periods

        /// <inheritdoc/>
        public override string Name => "standing-wave";

        /// <inheritdoc/>
        public override IReadOnlyList<string> Words => new[] { "waves" };

        /// <inheritdoc/>
        public override string LengthTitle => "the depth of the water";

        /// <inheritdoc/>
        public override string Title => "Standing wave";

        /// <inheritdoc/>
        public override string Source =>
            "linear waves, ω² = g k tanh kH, energy as e^(−4νk²t); set-up of AQUAgpusph, souto_etal_2012_standingwave";

        /// <inheritdoc/>
        public override string ErrorName => StandingWaveMetric.ErrorName;

        /// <inheritdoc/>
        public override IReadOnlyList<(string Name, double Right)> AlsoHeld => new[] { ("numerical viscosity/ν", 0.0) };

        /// <summary>
        /// A wave of finite amplitude is slower by (ka)²/8 in deep water (Penney and Price 1952), which linear theory leaves out.
        /// </summary>
        public override double Floor => WaveNumber * WaveNumber * Amplitude * Amplitude / 8.0;

        /// <inheritdoc/>
        public override string FloorSource =>
            "the reference's own, as a wave of this height is slower than a low one by (k a)²/8";

        /// <inheritdoc/>
        public override (string X, string Y) AxisTitles => ("t [s]", "first mode of the elevation over its start");

        /// <inheritdoc/>
        public override CaseParameters Base(CaseMethod method) => CaseParameters.At(method, 20, 6.0);

        /// <inheritdoc/>
        public override CaseSetup Build(in CaseParameters parameters)
        {
            WallCaseSetup.Require(parameters, Name, 6);
            double dx = Depth / parameters.Resolution;
            int width = WallCaseSetup.PeriodicCount(parameters);
            var domain = new Vector3((float)Length, (float)(Depth + 2.0 * Amplitude + 4.0 * dx), (float)(width * dx));
            FluidSolverSettings settings = CaseSettings.For(parameters, domain, dx, Math.Sqrt(Gravity * Depth),
                new Vector3(0f, -(float)Gravity, 0f), Viscosity, new FluidBoundaries { Periodic = FluidAxes.X | FluidAxes.Z });
            return new CaseSetup
            {
                Settings = settings,
                Particles = Wave(parameters, settings, width, dx),
                Duration = Lasts * Period,
                SampleInterval = Period / SamplesPerPeriod,
            };
        }

        /// <inheritdoc/>
        public override CaseMetric CreateMetric(in CaseParameters parameters, CaseSetup setup) =>
            new StandingWaveMetric(-0.5 * setup.Settings.DomainSize.y, Depth, WaveNumber, Frequency, Viscosity, Amplitude,
                FitFrom * Period);

        /// <summary>ω = √(g k tanh kH) [1/s].</summary>
        internal static double Frequency => Math.Sqrt(Gravity * WaveNumber * Math.Tanh(WaveNumber * Depth));

        private static double Period => 2.0 * Math.PI / Frequency;

        // A lattice at rest, moved as the linear wave moves it at its crest: −a sin kx cosh ky/sinh kH, a cos kx sinh ky/sinh kH.
        private static FluidParticle[] Wave(in CaseParameters parameters, in FluidSolverSettings settings, int width, double dx)
        {
            Vector3 domain = settings.DomainSize;
            double m = WallCaseSetup.Stiffness(parameters, settings);
            double scale = Amplitude / Math.Sinh(WaveNumber * Depth);
            var counts = new Vector3Int((int)Math.Round(Length / dx), parameters.Resolution, width);
            List<Vector3> positions = CaseLattice.Box(counts, dx, new Vector3(-0.5f * domain.x, 0f, -0.5f * domain.z));
            for (int i = 0; i < positions.Count; i++)
            {
                double x = positions[i].x, y = positions[i].y;
                double moved = x - scale * Math.Sin(WaveNumber * x) * Math.Cosh(WaveNumber * y);
                double lifted = WallCaseSetup.Settled(y, Depth, m) + scale * Math.Cos(WaveNumber * x) * Math.Sinh(WaveNumber * y);
                positions[i] = new Vector3((float)moved, (float)lifted - 0.5f * domain.y, positions[i].z);
            }
            return WallCaseSetup.AtRest(positions, parameters, dx, domain);
        }
    }
}
