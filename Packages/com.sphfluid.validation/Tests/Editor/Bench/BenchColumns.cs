using System;
using System.Linq;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    /// <summary>Reads a table as its file has it.</summary>
    static class BenchColumns
    {
        /// <summary>A column's cells without its head.</summary>
        public static string[] Column(this BenchTable table, string head)
        {
            string[][] lines = table.Lines().Select(CsvText.Split).ToArray();
            int column = Array.IndexOf(lines[0], head);
            return lines.Skip(1).Select(cells => cells[column]).ToArray();
        }
    }
}
