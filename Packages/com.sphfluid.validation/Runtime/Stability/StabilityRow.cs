using System;
using System.Collections.Generic;
using System.Globalization;

namespace SphFluid.Validation
{
    /// <summary>A line of stability.csv: a run and its judgement.</summary>
    public sealed class StabilityRow
    {
        /// <summary>Name of the file.</summary>
        public const string FileName = "stability.csv";

        /// <summary>The columns of the file.</summary>
        public static readonly IReadOnlyList<string> Columns = new[]
        {
            "map", "method", "x", "y", "seed", "verdict", "reason", "time_to_failure_s", "clamps", "particles", "steps", "device", "date", "cause",
        };

        /// <summary>Name of the map.</summary>
        public string Map { get; private set; }

        /// <summary>Name of the method.</summary>
        public string Method { get; private set; }

        /// <summary>Horizontal and vertical place in the map.</summary>
        public double X { get; private set; }

        /// <summary>Vertical place in the map.</summary>
        public double Y { get; private set; }

        /// <summary>Seed of the start's jitter.</summary>
        public int Seed { get; private set; }

        /// <summary>Whether the emergency limit on accelerations acted.</summary>
        public bool Clamps { get; private set; }

        /// <summary>The judgement.</summary>
        public StabilityOutcome Outcome { get; private set; }

        /// <summary>The graphics device.</summary>
        public string Device { get; private set; }

        /// <summary>Day of the run, e.g. 2026-11-21.</summary>
        public string Date { get; private set; }

        /// <summary>Equal to the key of its run.</summary>
        public string Key => StabilityRun.KeyOf(Map, Method, X, Y, Seed, Clamps);

        /// <summary>The line of a run.</summary>
        public static StabilityRow Of(StabilityRun run, StabilityOutcome outcome, string device, string date) => new StabilityRow
        {
            Map = run.Map.Name, Method = run.Method.Name, X = run.X, Y = run.Y, Seed = run.Seed, Clamps = run.Clamps,
            Outcome = outcome, Device = device, Date = date,
        };

        /// <summary>The line in the file.</summary>
        public string ToLine() => CsvText.Join(new[]
        {
            Map, Method, CsvText.Text(X), CsvText.Text(Y), CsvText.Text(Seed), Outcome.Verdict.ToString().ToLowerInvariant(), Outcome.Reason,
            CsvText.Text(Outcome.TimeToFailure), Clamps ? "on" : "off", CsvText.Text(Outcome.Particles), CsvText.Text(Outcome.Steps), Device, Date,
            StabilityCauses.Name(Outcome.Cause),
        });

        /// <summary>Reads a line of the file.</summary>
        /// <exception cref="FormatException">It does not have the columns.</exception>
        public static StabilityRow FromLine(string line)
        {
            string[] cells = ResumedTable.Cells(line, Columns.Count);
            if (!Enum.TryParse(cells[5], true, out StabilityVerdict verdict))
                throw new FormatException($"there is no verdict '{cells[5]}'");
            return new StabilityRow
            {
                Map = cells[0],
                Method = cells[1],
                X = ResumedTable.Number(cells[2]),
                Y = ResumedTable.Number(cells[3]),
                Seed = int.Parse(cells[4], CultureInfo.InvariantCulture),
                Clamps = cells[8] == "on",
                Device = cells[11],
                Date = cells[12],
                Outcome = new StabilityOutcome
                {
                    Verdict = verdict,
                    Reason = cells[6],
                    TimeToFailure = ResumedTable.Number(cells[7]),
                    Particles = int.Parse(cells[9], CultureInfo.InvariantCulture),
                    Steps = long.Parse(cells[10], CultureInfo.InvariantCulture),
                    Cause = StabilityCauses.Find(cells[13]),
                },
            };
        }
    }
}
