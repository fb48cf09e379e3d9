using System.Collections.Generic;

namespace SphFluid.Validation
{
    /// <summary>The form of a table: the columns of its file, and its lines for people.</summary>
    public interface IBenchLayout
    {
        /// <summary>Columns of the file.</summary>
        IReadOnlyList<BenchColumn> Columns { get; }

        /// <summary>Head of the lines for people.</summary>
        string Head { get; }

        /// <summary>A row for people.</summary>
        string Line(BenchTable table, BenchRow row);
    }
}
