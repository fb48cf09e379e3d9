using System;

namespace SphFluid.Validation
{
    /// <summary>A run of the chart: a point and a seed.</summary>
    public sealed class ChartRun
    {
        // Work that a step has whatever the number of particles, in particles.
        const double StepOverhead = 200.0;

        // Part of a step's work that grows with the number of neighbours, at κ = 2.
        const double NeighbourShare = 0.6;

        // Without the corrections particles clump, and each has more neighbours; the Standard method visits them faster than the 27 cells' search.
        const double PrintedWeight = 2.5, StandardWeight = 0.5;

        /// <summary>A run.</summary>
        /// <param name="config">The point.</param>
        /// <param name="seed">Seed of the start's jitter.</param>
        public ChartRun(ChartConfig config, int seed)
        {
            Config = config;
            Seed = seed;
        }

        /// <summary>The point.</summary>
        public ChartConfig Config { get; }

        /// <summary>Seed of the start's jitter.</summary>
        public int Seed { get; }

        /// <summary>Expected work of a step of the Standard method at κ = 2.</summary>
        internal static double CostOfStandardStep(int particles) => StandardWeight * particles + StepOverhead;

        /// <summary>Expected work: particles × steps, weighted so that the thesis method at κ = 2 counts once and at κ = 3 about 2.4 times.</summary>
        public double Cost
        {
            get
            {
                if (Config.Problem != null)
                    return 0.0;
                double ratio = Config.SupportRatio / 2.0;
                double weight = 1.0 - NeighbourShare + NeighbourShare * ratio * ratio * ratio;
                return Config.Steps * (Config.Particles * weight * MethodWeight + StepOverhead);
            }
        }

        double MethodWeight
        {
            get
            {
                switch (Config.Method.Kind)
                {
                    case FluidMethodKind.ThesisPrinted: return PrintedWeight;
                    case FluidMethodKind.Standard: return StandardWeight;
                    default: return 1.0;
                }
            }
        }

        /// <summary>Equal for runs of the same point and seed.</summary>
        public string Key => KeyOf(Config.Key, Seed);

        /// <summary>For progress lines.</summary>
        public override string ToString() => $"{Config}, seed {Seed}";

        internal static string KeyOf(string point, int seed) => point + "|" + CsvText.Text(seed);
    }
}
