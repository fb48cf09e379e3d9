using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>A line of accuracy.csv: one error of one run.</summary>
    public sealed class ChartRow
    {
        /// <summary>The columns of the file.</summary>
        public static readonly IReadOnlyList<string> Columns = new[]
        {
            "case", "method", "dx", "kappa", "dt_fraction", "c_or_iterations", "particles", "seed", "gpu_ms_per_sim_s", "cpu_ms_per_sim_s",
            "error", "error_name", "failed", "reason", "device", "date", "steps",
        };

        /// <summary>Name of the case.</summary>
        public string Case { get; private set; }

        /// <summary>Name of the method.</summary>
        public string Method { get; private set; }

        /// <summary>Particle spacing dx [m].</summary>
        public double Spacing { get; private set; }

        /// <summary>κ = R/dx.</summary>
        public double SupportRatio { get; private set; }

        /// <summary>Time step over the method's stable one.</summary>
        public double TimeStepFraction { get; private set; }

        /// <summary>Speed of sound over the case's own speed.</summary>
        public double SoundSpeedRatio { get; private set; }

        /// <summary>Number of particles.</summary>
        public int Particles { get; private set; }

        /// <summary>Seed of the start's jitter.</summary>
        public int Seed { get; private set; }

        /// <summary>GPU time per simulated second [ms/s]; not a number when it was not measured.</summary>
        public double GpuMsPerSecond { get; private set; }

        /// <summary>CPU time per simulated second [ms/s]; not a number when it was not measured.</summary>
        public double CpuMsPerSecond { get; private set; }

        /// <summary>The error, a fraction unless its name has a unit; not a number when there is none.</summary>
        public double Error { get; private set; }

        /// <summary>Name of the error.</summary>
        public string ErrorName { get; private set; }

        /// <summary>Whether the run failed.</summary>
        public bool Failed { get; private set; }

        /// <summary>Why; empty when it did not.</summary>
        public string Reason { get; private set; }

        /// <summary>The graphics device.</summary>
        public string Device { get; private set; }

        /// <summary>Day of the run, e.g. 2026-11-21.</summary>
        public string Date { get; private set; }

        /// <summary>Steps done.</summary>
        public long Steps { get; private set; }

        /// <summary>The name of the point: see <see cref="ChartConfig.Key"/>.</summary>
        public string Key => ChartConfig.KeyOf(Case, Method, Spacing, SupportRatio, TimeStepFraction, SoundSpeedRatio);

        /// <summary>The lines of a run: one for each error, the main one first; one without an error when it has none.</summary>
        /// <param name="run">What was run.</param>
        /// <param name="result">What came out.</param>
        /// <param name="device">The graphics device.</param>
        /// <param name="date">Day of the run.</param>
        public static IReadOnlyList<ChartRow> Of(ChartRun run, CaseResult result, string device, string date)
        {
            ChartConfig config = run.Config;
            IReadOnlyList<CaseError> errors = result.Errors.Count > 0 ? result.Errors : new[] { new CaseError(config.Case.ErrorName, double.NaN) };
            bool unmeasured = double.IsNaN(errors[0].Value) || double.IsInfinity(errors[0].Value);
            string reason = result.Failure ?? (unmeasured ? $"{errors[0].Name} could not be measured" : "");
            return errors.Select(error => new ChartRow
            {
                Case = config.Case.Name,
                Method = config.Method.Name,
                Spacing = config.Spacing,
                SupportRatio = config.SupportRatio,
                TimeStepFraction = config.TimeStepFraction,
                SoundSpeedRatio = config.SoundSpeedRatio,
                Particles = config.Particles,
                Seed = run.Seed,
                GpuMsPerSecond = result.GpuMsPerSecond,
                CpuMsPerSecond = result.CpuMsPerSecond,
                Error = error.Value,
                ErrorName = error.Name,
                Failed = result.Failed || unmeasured,
                Reason = reason,
                Device = device,
                Date = date,
                Steps = result.Steps,
            }).ToArray();
        }

        /// <summary>The line in the file.</summary>
        public string ToLine() => CsvText.Join(new[]
        {
            Case, Method, CsvText.Text(Spacing), CsvText.Text(SupportRatio), CsvText.Text(TimeStepFraction), CsvText.Text(SoundSpeedRatio),
            CsvText.Text(Particles), CsvText.Text(Seed), CsvText.Text(GpuMsPerSecond), CsvText.Text(CpuMsPerSecond),
            CsvText.Text(Error), ErrorName, Failed ? "1" : "0", Reason, Device, Date, CsvText.Text(Steps),
        });

        /// <summary>Reads a line of the file.</summary>
        /// <exception cref="FormatException">It does not have the columns.</exception>
        public static ChartRow FromLine(string line)
        {
            string[] cells = ResumedTable.Cells(line, Columns.Count);
            return new ChartRow
            {
                Case = cells[0],
                Method = cells[1],
                Spacing = ResumedTable.Number(cells[2]),
                SupportRatio = ResumedTable.Number(cells[3]),
                TimeStepFraction = ResumedTable.Number(cells[4]),
                SoundSpeedRatio = ResumedTable.Number(cells[5]),
                Particles = int.Parse(cells[6], CultureInfo.InvariantCulture),
                Seed = int.Parse(cells[7], CultureInfo.InvariantCulture),
                GpuMsPerSecond = ResumedTable.Number(cells[8]),
                CpuMsPerSecond = ResumedTable.Number(cells[9]),
                Error = ResumedTable.Number(cells[10]),
                ErrorName = cells[11],
                Failed = cells[12] == "1",
                Reason = cells[13],
                Device = cells[14],
                Date = cells[15],
                Steps = long.Parse(cells[16], CultureInfo.InvariantCulture),
            };
        }
    }
}
