using System;

namespace SphFluid.Validation
{
    /// <summary>A column of a table: its head, and its cell of a row.</summary>
    public readonly struct BenchColumn
    {
        readonly Func<BenchTable, BenchRow, string> cell;

        /// <summary>A column whose cell depends on the row alone.</summary>
        public BenchColumn(string head, Func<BenchRow, string> cell)
            : this(head, (table, row) => cell(row))
        {
        }

        /// <summary>A column whose cell depends on other rows too.</summary>
        public BenchColumn(string head, Func<BenchTable, BenchRow, string> cell)
        {
            Head = head;
            this.cell = cell;
        }

        /// <summary>The first line's cell.</summary>
        public string Head { get; }

        /// <summary>The row's cell.</summary>
        public string Cell(BenchTable table, BenchRow row) => cell(table, row);
    }
}
