namespace SphFluid.Validation
{
    /// <summary>A line of shard-runs.csv: a run that a shard has finished, so that its rows are complete.</summary>
    internal sealed class ShardRunRow : MeasuredRow
    {
        /// <summary>The file.</summary>
        public static readonly TableFormat<ShardRunRow> Format = new TableFormat<ShardRunRow>("shard-runs.csv")
            .Text("run", r => r.Run, (r, v) => r.Run = v)
            .Number("seconds", r => r.Seconds, (r, v) => r.Seconds = v)
            .Text("device", r => r.Device, (r, v) => r.Device = v)
            .Text("date", r => r.Date, (r, v) => r.Date = v);

        /// <summary>The run's name: see <see cref="ShardedTable.RunKey{TRow}"/>.</summary>
        public string Run = "";

        /// <summary>Wall time [s]; not a number where the session was stopped before it was written.</summary>
        public double Seconds = double.NaN;

        /// <inheritdoc/>
        public override string Key => Run;
    }
}
