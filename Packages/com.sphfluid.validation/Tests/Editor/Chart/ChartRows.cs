using System.Collections.Generic;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    /// <summary>Rows of made-up runs, without a file.</summary>
    internal sealed class ChartRows
    {
        private readonly List<ChartRow> rows = new List<ChartRow>();

        public ChartRows(string device) => Device = device;

        public string Device { get; }

        public IReadOnlyList<ChartRow> Rows => rows;

        public void Add(ChartRun run, CaseResult result, string date)
        {
            rows.RemoveAll(r => r.Key == run.Key);
            foreach (ChartRow row in ChartRow.Of(run, result))
            {
                (row.Device, row.Date) = (Device, date);
                rows.Add(row);
            }
        }
    }
}
