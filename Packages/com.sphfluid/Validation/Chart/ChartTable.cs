using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>accuracy.csv: what was measured so far, on one device.</summary>
    public sealed class ChartTable
    {
        /// <summary>Name of the file.</summary>
        public const string FileName = "accuracy.csv";

        readonly List<ChartRow> rows = new List<ChartRow>();

        /// <summary>An empty table.</summary>
        /// <param name="device">The graphics device.</param>
        public ChartTable(string device)
        {
            Device = device;
        }

        /// <summary>The graphics device.</summary>
        public string Device { get; }

        /// <summary>The lines in the order of their runs.</summary>
        public IReadOnlyList<ChartRow> Rows => rows;

        /// <summary>The table of a folder; an empty one where there is none.</summary>
        /// <param name="folder">The folder.</param>
        /// <param name="device">The graphics device that goes on with it.</param>
        /// <exception cref="CommandLineException">The file has other columns, a broken line, or another device's runs.</exception>
        public static ChartTable Load(string folder, string device)
        {
            const string cure = "Choose another folder with --out, or move the file away.";
            var table = new ChartTable(device);
            string file = Path.Combine(folder, FileName);
            if (!File.Exists(file))
                return table;
            string[] lines = File.ReadAllLines(file);
            if (lines.Length == 0 || lines[0] != CsvText.Join(ChartRow.Columns))
                throw new CommandLineException($"'{file}' does not have the columns of this version's accuracy.csv. {cure}");
            for (int i = 1; i < lines.Length; i++)
            {
                try
                {
                    table.rows.Add(ChartRow.FromLine(lines[i]));
                }
                catch (Exception exception) when (exception is FormatException || exception is OverflowException)
                {
                    throw new CommandLineException($"'{file}' has a broken line {i + 1}: {exception.Message}. Remove the line, and its run is done again.");
                }
            }
            ChartRow other = table.rows.FirstOrDefault(r => r.Device != device);
            if (other != null)
                throw new CommandLineException($"'{file}' has runs of '{other.Device}', and this is '{device}': their times do not compare. {cure}");
            return table;
        }

        /// <summary>Whether a run is there, with as many particles as it would have now.</summary>
        public bool Contains(ChartRun run) =>
            rows.Any(r => r.Seed == run.Seed && r.Particles == run.Config.Particles && r.Case == run.Config.Case.Name && r.Key == run.Config.Key);

        /// <summary>Adds a run; an older one of the same point and seed goes.</summary>
        /// <param name="run">The run.</param>
        /// <param name="result">What came out.</param>
        /// <param name="date">Day of the run.</param>
        public void Add(ChartRun run, CaseResult result, string date)
        {
            rows.RemoveAll(r => r.Seed == run.Seed && r.Key == run.Config.Key);
            rows.AddRange(ChartRow.Of(run, result, Device, date));
        }

        /// <summary>Writes the file whole.</summary>
        /// <param name="folder">Its folder.</param>
        public void Write(string folder) =>
            CsvText.WriteWhole(Path.Combine(folder, FileName), new[] { CsvText.Join(ChartRow.Columns) }.Concat(rows.Select(r => r.ToLine())));
    }
}
