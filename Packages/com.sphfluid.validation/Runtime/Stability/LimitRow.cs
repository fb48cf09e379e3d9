using System;
using System.Collections.Generic;

namespace SphFluid.Validation
{
    /// <summary>A line of limits.csv: a measured border against theory.</summary>
    public sealed class LimitRow
    {
        /// <summary>Name of the file.</summary>
        public const string FileName = "limits.csv";

        /// <summary>The columns of the file.</summary>
        public static readonly IReadOnlyList<string> Columns = new[]
        {
            "limit", "method", "kappa", "measured_low", "measured_high", "theory_low", "theory_high", "within_5_percent", "device", "date",
        };

        // What theory is allowed to be off.
        const double Allowed = 0.05;

        /// <summary>Name of the limit.</summary>
        public string Limit { get; private set; }

        /// <summary>Name of the method.</summary>
        public string Method { get; private set; }

        /// <summary>κ = R/dx.</summary>
        public double SupportRatio { get; private set; }

        /// <summary>Greatest stable value; zero when none was.</summary>
        public double MeasuredLow { get; private set; }

        /// <summary>Least unstable value; not a number when none was.</summary>
        public double MeasuredHigh { get; private set; }

        /// <summary>Least border by theory.</summary>
        public double TheoryLow { get; private set; }

        /// <summary>Greatest border by theory.</summary>
        public double TheoryHigh { get; private set; }

        /// <summary>The graphics device.</summary>
        public string Device { get; private set; }

        /// <summary>Day of the runs.</summary>
        public string Date { get; private set; }

        /// <summary>Whether the measured border is within 5 % of theory's range.</summary>
        public bool IsWithin => MeasuredLow >= TheoryLow * (1.0 - Allowed) && MeasuredHigh <= TheoryHigh * (1.0 + Allowed);

        /// <summary>Equal for the same limit and method.</summary>
        public string Key => KeyOf(Limit, Method, SupportRatio);

        /// <summary>The line of a finished search.</summary>
        public static LimitRow Of(StabilityLimit limit, CaseMethod method, Bisection search, string device, string date) => new LimitRow
        {
            Limit = limit.Name, Method = method.Name, SupportRatio = limit.SupportRatio, MeasuredLow = search.Low,
            MeasuredHigh = double.IsInfinity(search.High) ? double.NaN : search.High,
            TheoryLow = limit.TheoryLow, TheoryHigh = limit.TheoryHigh, Device = device, Date = date,
        };

        /// <summary>The line in the file.</summary>
        public string ToLine() => CsvText.Join(new[]
        {
            Limit, Method, CsvText.Text(SupportRatio), CsvText.Text(MeasuredLow), CsvText.Text(MeasuredHigh), CsvText.Text(TheoryLow),
            CsvText.Text(TheoryHigh), IsWithin ? "1" : "0", Device, Date,
        });

        /// <summary>Reads a line of the file.</summary>
        /// <exception cref="FormatException">It does not have the columns.</exception>
        public static LimitRow FromLine(string line)
        {
            string[] cells = ResumedTable.Cells(line, Columns.Count);
            return new LimitRow
            {
                Limit = cells[0],
                Method = cells[1],
                SupportRatio = ResumedTable.Number(cells[2]),
                MeasuredLow = ResumedTable.Number(cells[3]),
                MeasuredHigh = ResumedTable.Number(cells[4]),
                TheoryLow = ResumedTable.Number(cells[5]),
                TheoryHigh = ResumedTable.Number(cells[6]),
                Device = cells[8],
                Date = cells[9],
            };
        }

        internal static string KeyOf(string limit, string method, double kappa) => string.Join("|", limit, method, CsvText.Text(kappa));
    }
}
