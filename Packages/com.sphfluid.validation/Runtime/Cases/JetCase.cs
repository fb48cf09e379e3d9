using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// A plane jet, b = 1 m wide and 8 m long, hits a wall at right angles at U = 1 m/s, without gravity, and leaves along it in two sheets
    /// of half its width. A thin slab, periodic across; the wall is a face of the domain and pushes without friction.
    /// </summary>
    public sealed class JetCase : ValidationCase
    {
        private const double Width = 1.0, Speed = 1.0;
        private const double Length = 8.0;
        // of the domain: the first touch throws spray along the wall at more than 2 U, and what piles up at an end would push on the wall
        private const double HalfHeight = 20.0;
        private const double From = 3.0, To = 6.0; // of what is even, in b/U
        private const double Interval = 0.05;

        /// <inheritdoc/>
        public override string Name => "jet";

        /// <inheritdoc/>
        public override IReadOnlyList<string> Words => new[] { "hose" };

        /// <inheritdoc/>
        public override string LengthTitle => "the jet's width";

        /// <inheritdoc/>
        public override string Title => "A jet hits a wall";

        /// <inheritdoc/>
        public override string Source => "exact: balance of momentum, free streamlines (Milne-Thomson, Theoretical Hydrodynamics, ch. XI)";

        /// <inheritdoc/>
        public override string ErrorName => JetMetric.ErrorName;

        /// <inheritdoc/>
        public override IReadOnlyList<(string Name, double Right)> AlsoHeld =>
            new[] { ("speed of the sheets over U − 1", 0.0), ("energy lost by the sheets", 0.0) };

        /// <summary>The liquid's own compression where it is stopped is ½ (U/c)² at the base.</summary>
        /// <inheritdoc/>
        public override double Floor => 0.005;

        /// <inheritdoc/>
        public override string FloorSource =>
            "the reference's own, as it is of a liquid that ½(U/c)² does not compress";

        /// <inheritdoc/>
        public override (string X, string Y) AxisTitles => ("t U/b", "force over ρ U² b a metre");

        /// <inheritdoc/>
        public override CaseParameters Base(CaseMethod method) => CaseParameters.At(method, 12, 10.0);

        /// <summary><see cref="CaseParameters.Resolution"/> particles across the jet; speeds are over the jet's own.</summary>
        /// <inheritdoc/>
        public override CaseSetup Build(in CaseParameters parameters)
        {
            WallCaseSetup.Require(parameters, Name, 4);
            double dx = Width / parameters.Resolution;
            int across = WallCaseSetup.PeriodicCount(parameters);
            var domain = new Vector3((float)(Length + 1.0), (float)(2.0 * HalfHeight), (float)(across * dx));
            var counts = new Vector3Int((int)Math.Round(Length / dx), parameters.Resolution, across);
            var corner = new Vector3(-0.5f * domain.x, (float)(-0.5 * Width), -0.5f * domain.z);
            var positions = CaseLattice.Box(counts, dx, corner);
            CaseLattice.Jitter(positions, parameters.Jitter * dx, parameters.Seed, 0.4999f * domain);
            return new CaseSetup
            {
                Settings = CaseSettings.For(parameters, domain, dx, Speed, Vector3.zero, null,
                    new FluidBoundaries { Periodic = FluidAxes.Z }),
                Particles = CaseLattice.Particles(positions, p => new Vector3(-(float)Speed, 0f, 0f)),
                Duration = To * Width / Speed,
                SampleInterval = Interval * Width / Speed,
                Patches = JetWall.Patches(domain, Width),
            };
        }

        /// <inheritdoc/>
        public override CaseMetric CreateMetric(in CaseParameters parameters, CaseSetup setup) =>
            new JetMetric(Width, Length, Speed, From, To, setup.Settings.ParticleMass / Math.Pow(setup.Settings.Spacing, 3.0));
    }
}
