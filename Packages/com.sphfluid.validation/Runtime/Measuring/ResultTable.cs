using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>The rows that one device gave, and their file, which is written whole after every change.</summary>
    public sealed class ResultTable<TRow> where TRow : MeasuredRow
    {
        private const string Cure = "Choose another folder with --out, or move the file away.";

        private readonly string folder;
        private readonly List<TRow> rows = new List<TRow>();
        private readonly HashSet<string> keys = new HashSet<string>();

        /// <summary>An empty table; its file is written with the first row.</summary>
        /// <param name="format">Name and columns of the file.</param>
        /// <param name="folder">Folder of the file.</param>
        /// <param name="device">The graphics device.</param>
        public ResultTable(TableFormat<TRow> format, string folder, string device)
        {
            Format = format;
            Device = device;
            this.folder = folder;
        }

        /// <summary>Name and columns of the file.</summary>
        public TableFormat<TRow> Format { get; }

        /// <summary>The graphics device.</summary>
        public string Device { get; }

        /// <summary>The rows in the order of their runs.</summary>
        public IReadOnlyList<TRow> Rows => rows;

        /// <summary>The table of a folder, to be continued on the same device; an empty one where there is no file.</summary>
        /// <param name="format">Name and columns of the file.</param>
        /// <param name="folder">Folder of the file.</param>
        /// <param name="device">The device that continues.</param>
        /// <param name="create">An empty row.</param>
        /// <exception cref="CommandLineException">The file has other columns, a broken line, or another device's runs.</exception>
        public static ResultTable<TRow> Resume(TableFormat<TRow> format, string folder, string device, Func<TRow> create)
        {
            var table = new ResultTable<TRow>(format, folder, device);
            string file = Path.Combine(folder, format.FileName);
            if (File.Exists(file)) table.Load(file, create);
            return table;
        }

        /// <summary>Whether a run is there.</summary>
        /// <param name="key">Its key, see <see cref="MeasuredRow.Key"/>.</param>
        public bool Contains(string key) => keys.Contains(key);

        /// <summary>Adds the rows of a run, in place of older ones of the same run, and writes the file.</summary>
        /// <param name="added">The rows; device and, where they have none, date are set.</param>
        public void Add(params TRow[] added)
        {
            rows.RemoveAll(old => old.Key != null && added.Any(row => row.Key == old.Key));
            foreach (TRow row in added)
            {
                row.Device = Device;
                if (row.Date.Length == 0) row.Date = DateTime.UtcNow.ToString("yyyy-MM-dd", CultureInfo.InvariantCulture);
                Append(row);
            }
            Write();
        }

        /// <summary>Writes the rows that are measured.</summary>
        public void Write() => Format.Write(folder, rows.Where(r => r.IsMeasured));

        private void Append(TRow row)
        {
            rows.Add(row);
            if (row.Key != null) keys.Add(row.Key);
        }

        private void Load(string file, Func<TRow> create)
        {
            string[] lines = File.ReadAllLines(file);
            if (lines.Length == 0 || lines[0] != Format.FirstLine)
            {
                throw new CommandLineException(
                    $"'{file}' does not have the columns of this " +
                    $"version{(lines.Length > 0 && Format.Reads(lines[0]) ? ", but those of an earlier one" : "")}. {Cure}");
            }
            for (int i = 1; i < lines.Length; i++)
            {
                TRow row = create();
                try
                {
                    Format.Read(lines[i], row);
                }
                catch (Exception exception) when (exception is FormatException || exception is OverflowException)
                {
                    throw new CommandLineException(
                        $"'{file}' has a broken line {i + 1}: {exception.Message}. Remove the line, and its run is done again.");
                }
                Append(row);
            }
            TRow other = rows.Find(r => r.Device != Device);
            if (other != null) throw new CommandLineException($"'{file}' has runs of '{other.Device}', and this is '{Device}'. {Cure}");
        }
    }
}
