namespace SphFluid.Validation
{
    /// <summary>A line of shard-plan.csv: a run of the whole sweep.</summary>
    internal sealed class PlannedRun
    {
        /// <summary>The run's name: see <see cref="ShardedTable.RunKey{TRow}"/>.</summary>
        public string Key;

        /// <summary>Expected work, four digits as the deal takes it.</summary>
        public string Cost;

        /// <summary>The shard that does it, from 1.</summary>
        public int Shard;
    }
}
