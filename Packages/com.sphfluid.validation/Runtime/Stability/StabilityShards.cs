namespace SphFluid.Validation
{
    /// <summary>How the shards of stability maps become the whole.</summary>
    internal static class StabilityShards
    {
        /// <summary>Tables, and the session that draws.</summary>
        public static ShardedVerb Verb { get; } = new ShardedVerb("stability",
            new[]
            {
                ShardedTable.Of(StabilityRow.Format, new[] { "map", "method", "x", "y", "seed", "clamps" }),
                ShardedTable.Of(LimitRow.Format, new[] { "limit", "method", "kappa" }),
            },
            _ => StabilitySession.Files,
            finish: (words, device, progress) => StabilitySession.OfTables(StabilityArguments.Parse(words), device, progress));
    }
}
