using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>
    /// Name and columns of a CSV file. A column is stated once: its name, its cell of a row and, where the file is read again, how a row
    /// takes the cell. Example: <c>new TableFormat&lt;Fall&gt;("fall.csv").Text("case", r => r.Case).Number("speed_m_s", r => r.Speed)</c>.
    /// </summary>
    public sealed class TableFormat<TRow>
    {
        private readonly List<(string Name, Func<TRow, string> Cell, Action<TRow, string> Take)> columns =
            new List<(string, Func<TRow, string>, Action<TRow, string>)>();

        private int required;
        private bool hasLater;

        /// <summary>A table without columns.</summary>
        /// <param name="fileName">Name of the file.</param>
        public TableFormat(string fileName) => FileName = fileName;

        /// <summary>Name of the file.</summary>
        public string FileName { get; }

        /// <summary>Names of the columns.</summary>
        public IEnumerable<string> Names => columns.Select(c => c.Name);

        /// <summary>
        /// The first lines that are read: that of today, and those of files from before the columns behind <see cref="Later"/> were added.
        /// </summary>
        public bool Reads(string firstLine) => firstLine == FirstLine ||
            Enumerable.Range(required, columns.Count - required).Any(count => firstLine == CsvText.Join(Names.Take(count)));

        /// <summary>The first line of the file.</summary>
        public string FirstLine => CsvText.Join(Names);

        /// <summary>The file, for <see cref="ResultFolder"/>.</summary>
        internal ResultFile File => ResultFile.Text(FileName, FirstLine);

        /// <summary>The columns from here on were added later: files without them are read, but not continued.</summary>
        public TableFormat<TRow> Later()
        {
            required = columns.Count;
            hasLater = true;
            return this;
        }

        /// <summary>Adds a column of text.</summary>
        /// <param name="name">Name in the first line.</param>
        /// <param name="cell">The cell of a row.</param>
        /// <param name="take">Sets what the cell holds; may throw a FormatException. Null: the row has it otherwise.</param>
        public TableFormat<TRow> Text(string name, Func<TRow, string> cell, Action<TRow, string> take = null)
        {
            columns.Add((name, cell, take));
            if (!hasLater) required = columns.Count;
            return this;
        }

        /// <summary>Adds a column of numbers with six digits; the cell is empty for what is not a finite number.</summary>
        /// <param name="name">Name in the first line, with the unit.</param>
        /// <param name="value">The number of a row.</param>
        /// <param name="take">Sets the number.</param>
        public TableFormat<TRow> Number(string name, Func<TRow, double> value, Action<TRow, double> take = null) =>
            Text(name, row => CsvText.Text(value(row)), Parsed(take, CsvText.Number));

        /// <summary>Adds a column of whole numbers.</summary>
        /// <param name="name">Name in the first line.</param>
        /// <param name="value">The number of a row.</param>
        /// <param name="take">Sets the number.</param>
        public TableFormat<TRow> Count(string name, Func<TRow, long> value, Action<TRow, long> take = null) =>
            Text(name, row => CsvText.Text(value(row)), Parsed(take, cell => long.Parse(cell, CultureInfo.InvariantCulture)));

        /// <summary>Adds a column of one of two words.</summary>
        /// <param name="name">Name in the first line.</param>
        /// <param name="value">Whether the row has the first word.</param>
        /// <param name="take">Sets it.</param>
        /// <param name="yes">The first word.</param>
        /// <param name="no">The second word.</param>
        public TableFormat<TRow> Flag(string name, Func<TRow, bool> value, Action<TRow, bool> take = null, string yes = "1",
            string no = "0") =>
                Text(name, row => value(row) ? yes : no, Parsed(take, cell => cell == yes));

        /// <summary>The line of a row.</summary>
        public string Line(TRow row) => CsvText.Join(columns.Select(c => c.Cell(row)));

        /// <summary>The lines of a file.</summary>
        public IEnumerable<string> Lines(IEnumerable<TRow> rows) => new[] { FirstLine }.Concat(rows.Select(Line));

        /// <summary>Writes the file whole.</summary>
        /// <param name="folder">Its folder, made if there is none.</param>
        /// <param name="rows">Its rows.</param>
        public void Write(string folder, IEnumerable<TRow> rows) => CsvText.WriteWhole(Path.Combine(folder, FileName), Lines(rows));

        /// <summary>Reads a line into a row.</summary>
        /// <exception cref="FormatException">It does not have the columns.</exception>
        /// <exception cref="OverflowException">A number is too large.</exception>
        public void Read(string line, TRow row)
        {
            string[] cells = CsvText.Split(line);
            if (cells.Length < required || cells.Length > columns.Count)
            {
                throw new FormatException($"{cells.Length} cells instead of {columns.Count}");
            }
            for (int i = 0; i < cells.Length; i++) columns[i].Take?.Invoke(row, cells[i]);
        }

        /// <summary>The rows of a whole file, also of one from before later columns.</summary>
        /// <param name="file">The file.</param>
        /// <param name="create">An empty row.</param>
        /// <exception cref="FormatException">It has other columns, or a broken line; the message names the line.</exception>
        public List<TRow> ReadAll(string file, Func<TRow> create)
        {
            string[] lines = System.IO.File.ReadAllLines(file);
            if (lines.Length == 0 || !Reads(lines[0])) throw new FormatException($"'{file}' does not have the columns of {FileName}");
            int cells = CsvText.Split(lines[0]).Length;
            var rows = new List<TRow>();
            for (int i = 1; i < lines.Length; i++)
            {
                TRow row = create();
                try
                {
                    if (CsvText.Split(lines[i]).Length != cells) throw new FormatException($"it does not have {cells} cells");
                    Read(lines[i], row);
                }
                catch (Exception exception) when (exception is FormatException || exception is OverflowException)
                {
                    throw new FormatException($"'{file}' has a broken line {i + 1}: {exception.Message}");
                }
                rows.Add(row);
            }
            return rows;
        }

        private static Action<TRow, string> Parsed<T>(Action<TRow, T> take, Func<string, T> parse) =>
            take == null ? (Action<TRow, string>)null : (row, cell) => take(row, parse(cell));
    }
}
