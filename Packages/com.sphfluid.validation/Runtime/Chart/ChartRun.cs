namespace SphFluid.Validation
{
    /// <summary>A run of the chart: a point and a seed.</summary>
    public sealed class ChartRun
    {
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

        /// <summary>Expected work, see <see cref="StepWork"/>.</summary>
        public double Cost => Config.Problem != null ? 0.0
            : Config.Steps * StepWork.Of(Config.Method, Config.Particles, Config.SupportRatio);

        /// <summary>Equal for runs of the same point and seed.</summary>
        public string Key => KeyOf(Config.Key, Seed);

        /// <summary>For progress lines.</summary>
        public override string ToString() => $"{Config}, seed {Seed}";

        internal static string KeyOf(string point, int seed) => point + "|" + CsvText.Text(seed);
    }
}
