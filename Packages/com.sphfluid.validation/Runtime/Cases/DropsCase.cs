using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// Two equal drops, far enough from each other to be bodies apart, collide head-on in open space. The plane between them is a wall
    /// without friction that each hits at half the closing speed, so the impact on a plate is the reference. No drop knows of the other
    /// before they touch: what is kept over steps, such as lists of neighbours, shows here when it is kept too long.
    /// </summary>
    public sealed class DropsCase : ValidationCase
    {
        private const double Radius = 1.0;
        private const double Speed = 1.0; // of each
        private const double Gap = 1.0; // between the surfaces, over the radius: 8 dx, 3.5 R at the base
        private const double Samples = 40.0; // in D/U
        private const double HalfLength = 3.0, HalfWidth = 7.0; // of the domain, over the radius
        private const double SpeedLimit = 10.0; // the sheet between the drops starts at several times their speed

        /// <inheritdoc/>
        public override string Name => "drops";

        /// <inheritdoc/>
        public override IReadOnlyList<string> Words => new[] { "impact", "collision" };

        /// <inheritdoc/>
        public override string LengthTitle => "a drop's radius";

        /// <inheritdoc/>
        public override string Title => "Two drops collide";

        /// <inheritdoc/>
        public override string Source => "measured force of drops on plates: Mitchell et al. 2019, J. Fluid Mech. 867, 300";

        /// <inheritdoc/>
        public override string ErrorName => DropsMetric.ErrorName;

        /// <inheritdoc/>
        public override IReadOnlyList<(string Name, double Right)> AlsoHeld =>
            new[] { ("largest E/E0 − 1", 0.0), ("sheet, height over width − 1", 0.0) };

        /// <summary>The fit's peak force is 0.84 ρU²D² where others measured 0.81 to 0.86.</summary>
        /// <inheritdoc/>
        public override double Floor => 0.01;

        /// <inheritdoc/>
        public override string FloorSource =>
            "peak forces that others measured lie up to 4 % from the fit, which moves the momentum by so much";

        /// <inheritdoc/>
        public override (string X, string Y) AxisTitles => ("t U/D since the drops touched", "momentum of a drop over its start");

        /// <inheritdoc/>
        public override CaseParameters Base(CaseMethod method) => CaseParameters.At(method, 8, 10.0);

        /// <summary>Balls <see cref="CaseParameters.Resolution"/> particles in radius; speeds are over a drop's own.</summary>
        /// <inheritdoc/>
        public override CaseSetup Build(in CaseParameters parameters)
        {
            WallCaseSetup.Require(parameters, Name, 3);
            List<Vector3> ball = CaseLattice.Ball(Radius, Radius / parameters.Resolution);
            // The cut lattice has about the ball's volume; scaled it has it exactly.
            double dx = Math.Pow(4.0 / 3.0 * Math.PI / ball.Count, 1.0 / 3.0) * Radius;
            float scale = (float)(dx * parameters.Resolution / Radius);
            var offset = new Vector3((float)(Radius + 0.5 * Gap), 0f, 0f);
            var positions = new List<Vector3>();
            foreach (Vector3 p in ball) positions.Add(scale * p - offset);
            foreach (Vector3 p in ball) positions.Add(scale * p + offset);
            var domain = new Vector3((float)(2.0 * HalfLength), (float)(2.0 * HalfWidth), (float)(2.0 * HalfWidth));
            CaseLattice.Jitter(positions, parameters.Jitter * dx, parameters.Seed, 0.5f * domain);
            return new CaseSetup
            {
                Settings = CaseSettings.For(parameters, domain, dx, Speed, Vector3.zero),
                Particles = CaseLattice.Particles(positions, p => new Vector3(p.x < 0f ? (float)Speed : -(float)Speed, 0f, 0f)),
                Duration = ContactTime + 2.0 * Radius / Speed,
                SampleInterval = 2.0 * Radius / Speed / Samples,
                IsOpen = true,
                SpeedLimit = SpeedLimit * Speed,
            };
        }

        /// <inheritdoc/>
        public override CaseMetric CreateMetric(in CaseParameters parameters, CaseSetup setup) =>
            new DropsMetric(setup.Settings, Speed, 2.0 * Radius, ContactTime);

        // Each drop flies half of the gap.
        private static double ContactTime => 0.5 * Gap * Radius / Speed;
    }
}
