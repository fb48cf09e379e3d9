using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// Martin and Moyce's falling column of 1952, twice as high as wide: a = 0.05715 m as in the experiment (in units of a and
    /// √(a/g) the size does not matter, to the cost of a simulated second it does). A slab as thin as the neighbour grid allows,
    /// periodic across, in a tank 7 a long, so that the front reaches no wall; the other faces push without friction. The column starts
    /// compressed by its own weight, as it stands behind the gate: else its fall begins with a blow.
    /// </summary>
    public sealed class DamBreakCase : ValidationCase
    {
        private const double Gravity = 9.81;
        private const double TankLength = 7.0, TankHeight = 3.0; // over a
        private const double LastTime = 3.9; // in T: the last point, the largest shift and a sample

        // In T. The front turns by less than 1e-3 a from the straight line between two samples.
        private const double Interval = 0.05;

        /// <inheritdoc/>
        public override string Name => "dam-break";

        /// <inheritdoc/>
        public override IReadOnlyList<string> Words => new[] { "splash", "collapse" };

        /// <inheritdoc/>
        public override string LengthTitle => "the column's width, half of its height";

        /// <inheritdoc/>
        public override string Title => "Dam break, n² = 2";

        /// <inheritdoc/>
        public override string Source => "Martin and Moyce (1952), Phil. Trans. R. Soc. A 244, 312-324, tables 2 and 6";

        /// <inheritdoc/>
        public override string ErrorName => DamBreakMetric.ErrorName;

        /// <inheritdoc/>
        public override IReadOnlyList<(string Name, double Right)> AlsoHeld =>
            new[] { ("front, slope dZ/dT − 1", 0.0), ("height, largest error", 0.0) };

        /// <inheritdoc/>
        public override string CompanionErrorName => DamBreakMetric.RawName;

        /// <inheritdoc/>
        public override double Floor => MartinMoyce.Floor;

        /// <inheritdoc/>
        public override string FloorSource =>
            "two columns of the experiment lie so far apart, and another experiment 6 %";

        /// <inheritdoc/>
        public override string Caution =>
            "The raw error ranks methods backwards: the experiment's gate holds the front back by about 0.2 in T, " +
            "and a method that loses energy imitates the delay. Compare shifted errors, and none below the experiment's own 4 %.";

        /// <inheritdoc/>
        public override (string X, string Y) AxisTitles => ("T = t √(2g/a)", "front Z = x/a, height h = y/(2a)");

        /// <inheritdoc/>
        public override CaseParameters Base(CaseMethod method) => CaseParameters.At(method, 16, 5.0);

        /// <inheritdoc/>
        public override CaseSetup Build(in CaseParameters parameters)
        {
            WallCaseSetup.Require(parameters, Name, 4);
            const double a = MartinMoyce.Width;
            double dx = a / parameters.Resolution;
            int rows = WallCaseSetup.PeriodicCount(parameters);
            var domain = new Vector3((float)(TankLength * a), (float)(TankHeight * a), (float)(rows * dx));
            double speed = Math.Sqrt(2.0 * Gravity * 2.0 * a); // a fall from the top of the column
            FluidSolverSettings settings = CaseSettings.For(parameters, domain, dx, speed, new Vector3(0f, -(float)Gravity, 0f),
                null, new FluidBoundaries { Periodic = FluidAxes.Z });
            double unit = Math.Sqrt(a / (2.0 * Gravity));
            return new CaseSetup
            {
                Settings = settings,
                Particles = Column(parameters, settings, rows, dx),
                Duration = LastTime * unit,
                SampleInterval = Interval * unit,
            };
        }

        /// <inheritdoc/>
        public override CaseMetric CreateMetric(in CaseParameters parameters, CaseSetup setup) =>
            new DamBreakMetric(setup.Settings, MartinMoyce.Width, WallCaseSetup.PeriodicCount(parameters));

        private static FluidParticle[] Column(in CaseParameters parameters, in FluidSolverSettings settings, int rows, double dx)
        {
            var random = new System.Random(parameters.Seed);
            int wide = parameters.Resolution, layer = wide * rows;
            double depth = 2.0 * wide * dx, sound = CaseSettings.EffectiveSoundSpeed(settings), m = sound * sound / (Gravity * depth);
            Vector3 low = -0.5f * settings.DomainSize;
            var particles = new FluidParticle[layer * 2 * wide];
            for (int i = 0; i < particles.Length; i++)
            {
                double height = WallCaseSetup.Settled((i / layer + 0.5) * dx, depth, m);
                var place = new Vector3((float)((i % wide + 0.5) * dx), (float)height, (float)((i / wide % rows + 0.5) * dx));
                particles[i] = WallCaseSetup.Particle(low + place, (uint)i, parameters.Jitter * dx, random, settings);
            }
            return particles;
        }
    }
}
