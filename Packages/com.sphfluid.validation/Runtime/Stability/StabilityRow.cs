using System;

namespace SphFluid.Validation
{
    /// <summary>A line of stability.csv: a run of a map and its outcome.</summary>
    public sealed class StabilityRow : MeasuredRow
    {
        /// <summary>The file.</summary>
        public static readonly TableFormat<StabilityRow> Format = new TableFormat<StabilityRow>("stability.csv")
            .Text("map", r => r.Map, (r, v) => r.Map = v)
            .Text("method", r => r.Method, (r, v) => r.Method = v)
            .Number("x", r => r.X, (r, v) => r.X = v)
            .Number("y", r => r.Y, (r, v) => r.Y = v)
            .Count("seed", r => r.Seed, (r, v) => r.Seed = checked((int)v))
            .Text("verdict", r => r.Outcome.Verdict.ToString().ToLowerInvariant(), (r, v) => r.Outcome.Verdict = VerdictOf(v))
            .Text("reason", r => r.Outcome.Reason, (r, v) => r.Outcome.Reason = v)
            .Number("time_to_failure_s", r => r.Outcome.TimeToFailure, (r, v) => r.Outcome.TimeToFailure = v)
            .Flag("clamps", r => r.Clamps, (r, v) => r.Clamps = v, "on", "off")
            .Count("particles", r => r.Outcome.Particles, (r, v) => r.Outcome.Particles = checked((int)v))
            .Count("steps", r => r.Outcome.Steps, (r, v) => r.Outcome.Steps = v)
            .Text("device", r => r.Device, (r, v) => r.Device = v)
            .Text("date", r => r.Date, (r, v) => r.Date = v)
            .Text("cause", r => StabilityLegend.Name(r.Outcome.Cause), (r, v) => r.Outcome.Cause = StabilityLegend.Find(v));

        /// <summary>A row that is read from a file.</summary>
        public StabilityRow() => Outcome = new StabilityOutcome();

        internal StabilityRow(StabilityRun run, StabilityOutcome outcome)
        {
            Map = run.Map.Name;
            Method = run.Method.Name;
            X = run.X;
            Y = run.Y;
            Seed = run.Seed;
            Clamps = run.Clamps;
            Outcome = outcome;
        }

        /// <summary>Name of the map.</summary>
        public string Map { get; private set; }

        /// <summary>Name of the method.</summary>
        public string Method { get; private set; }

        /// <summary>Value of the map's horizontal axis.</summary>
        public double X { get; private set; }

        /// <summary>Value of the map's vertical axis.</summary>
        public double Y { get; private set; }

        /// <summary>Seed of the start's jitter.</summary>
        public int Seed { get; private set; }

        /// <summary>Whether the emergency limit on accelerations acted.</summary>
        public bool Clamps { get; private set; }

        /// <summary>How it went.</summary>
        public StabilityOutcome Outcome { get; }

        /// <summary>Equal to the key of its run.</summary>
        public override string Key => StabilityRun.KeyOf(Map, Method, X, Y, Seed, Clamps);

        private static StabilityVerdict VerdictOf(string name) =>
            Enum.TryParse(name, true, out StabilityVerdict verdict) ? verdict : throw new FormatException($"there is no verdict '{name}'");
    }
}
