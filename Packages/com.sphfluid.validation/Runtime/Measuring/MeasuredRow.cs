namespace SphFluid.Validation
{
    /// <summary>A line of a table: what a run gave, on which device and when.</summary>
    public abstract class MeasuredRow
    {
        /// <summary>The graphics device.</summary>
        public string Device { get; internal set; } = "";

        /// <summary>Day of the run, e.g. 2026-11-21.</summary>
        public string Date { get; internal set; } = "";

        /// <summary>Equal for rows of the same run, where a newer run replaces an older one; null: every row stays.</summary>
        public virtual string Key => null;

        /// <summary>Whether there is something to write.</summary>
        public virtual bool IsMeasured => true;
    }
}
