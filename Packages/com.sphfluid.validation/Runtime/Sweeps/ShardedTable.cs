using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>A table that shards write parts of. Its lines are merged as text, so that no digit changes.</summary>
    internal sealed class ShardedTable
    {
        private readonly string[] names;
        private readonly int[] key;
        private readonly HashSet<string> times;

        private ShardedTable(ResultFile file, string[] names, IEnumerable<string> key, IEnumerable<string> times)
        {
            File = file;
            this.names = names;
            this.key = key.Select(name => System.Array.IndexOf(names, name)).ToArray();
            this.times = new HashSet<string>(times);
        }

        /// <summary>The file.</summary>
        public ResultFile File { get; }

        /// <summary>Whether it holds nothing but times.</summary>
        public bool IsOfTimes { get; private set; }

        /// <summary>A table of results.</summary>
        /// <param name="format">Name and columns.</param>
        /// <param name="key">The columns that name a run; their cells joined by | are what the job's name has behind the table's, see
        /// <see cref="RunKey{TRow}"/>.</param>
        /// <param name="times">The columns that are times of the device: they differ between two runs that are alike.</param>
        public static ShardedTable Of<TRow>(TableFormat<TRow> format, string[] key, params string[] times) =>
            new ShardedTable(format.File, format.Names.ToArray(), key, times);

        /// <summary>A table of times.</summary>
        /// <param name="format">Name and columns.</param>
        /// <param name="key">The columns that name a run.</param>
        public static ShardedTable OfTimes<TRow>(TableFormat<TRow> format, params string[] key) =>
            new ShardedTable(format.File, format.Names.ToArray(), key, format.Names.Except(key)) { IsOfTimes = true };

        /// <summary>The name of a run in a sweep's plan, for instance "accuracy.csv|ellipsoid|standard|0.125|2|0.5|10|1".</summary>
        /// <param name="format">The table that the run's rows go to.</param>
        /// <param name="row">The run's name there.</param>
        public static string RunKey<TRow>(TableFormat<TRow> format, string row) => format.FileName + "|" + row;

        /// <summary>The name of the run that gave a line; null for a line without all of the columns.</summary>
        public string KeyOf(string line)
        {
            string[] cells = CsvText.Split(line);
            return cells.Length == names.Length ? File.Name + "|" + string.Join("|", key.Select(i => cells[i])) : null;
        }

        /// <summary>A line with empty cells in place of times.</summary>
        public string WithoutTimes(string line) =>
            CsvText.Join(CsvText.Split(line).Select((cell, i) => times.Contains(names[i]) ? "" : cell));

        /// <summary>The first column in which two lines of a run differ that is no time, day or device; null where there is none.</summary>
        public string Difference(string one, string other)
        {
            string[] a = CsvText.Split(one), b = CsvText.Split(other);
            return names.Where((name, i) => a[i] != b[i] && !times.Contains(name) && name != "date" && name != "device").FirstOrDefault();
        }

        /// <summary>The cell of a column.</summary>
        public string Cell(string line, string name) => CsvText.Split(line)[System.Array.IndexOf(names, name)];
    }
}
