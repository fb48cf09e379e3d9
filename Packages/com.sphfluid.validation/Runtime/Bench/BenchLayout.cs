using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>The form of a table of the benchmark: the columns of its file, and its lines for people.</summary>
    public abstract class BenchLayout
    {
        /// <param name="table">Name of the table, also the file's.</param>
        private protected BenchLayout(string table)
        {
            Format = new TableFormat<BenchRow>(table + ".csv")
                .Text("table", row => table).Text("device", row => row.Device).Text("config", row => row.Config.Name)
                .Text("method", row => row.Config.Solver.MethodName);
        }

        /// <summary>Name and columns of the file.</summary>
        public TableFormat<BenchRow> Format { get; }

        /// <summary>Head of the lines for people.</summary>
        public abstract string Head { get; }

        /// <summary>A row for people.</summary>
        public abstract string Line(BenchRow row);

        /// <summary>Adds what a frame cost.</summary>
        private protected TableFormat<BenchRow> AddTimes() =>
            Format.Number("dispatches", row => (double)row.Dispatches / System.Math.Max(1, row.Config.Steps))
            .Number("gpu_ms_median", row => row.Frame.Median).Number("gpu_ms_min", row => row.Frame.Minimum)
            .Number("gpu_ms_max", row => row.Frame.Maximum)
            .Flag("pass_stamps", row => false).Number("gpu_ms_stamped", row => row.Passes.Frame);

        /// <summary>Adds a column a part of a frame.</summary>
        private protected void AddParts(string prefix, IEnumerable<string> parts, Func<BenchRow, int, double> value)
        {
            foreach ((string name, int index) in parts.Select((name, i) => (name, i)))
            {
                Format.Number(prefix + name, row => value(row, index));
            }
        }

        /// <summary>Adds how often it was measured, and with what.</summary>
        private protected TableFormat<BenchRow> AddSamples() =>
            Format.Count("samples", row => row.SampleCount).Count("frames", row => row.FrameCount).Text("date", row => row.Date)
            .Text("driver", row => row.Machine.Driver).Text("processor", row => row.Machine.Processor)
            .Text("commit", row => row.Machine.Commit).Number("clock_mhz", row => row.Clock);

        /// <summary>A ratio for people; empty where there is none.</summary>
        private protected static string Short(double value) => double.IsNaN(value) ? ""
            : value.ToString("F2", CultureInfo.InvariantCulture);
    }
}
