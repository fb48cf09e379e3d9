namespace SphFluid.Validation
{
    /// <summary>How a run went, the worst last.</summary>
    public enum StabilityVerdict
    {
        /// <summary>Nothing is wrong.</summary>
        Stable,

        /// <summary>It did not fail, but is no good picture of the liquid.</summary>
        Degraded,

        /// <summary>It is no liquid any more.</summary>
        Failed,
    }
}
