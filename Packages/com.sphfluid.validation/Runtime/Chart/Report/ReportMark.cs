namespace SphFluid.Validation
{
    /// <summary>A place in a panel of the report that is no measured point: an answer, for instance, with its intervals.</summary>
    internal sealed class ReportMark
    {
        /// <param name="title">What it is.</param>
        /// <param name="cost">GPU ms per simulated second: the value, the least and the greatest.</param>
        /// <param name="error">The error: the value, the least and the greatest.</param>
        public ReportMark(string title, in SampleStatistics cost, in SampleStatistics error)
        {
            Title = title;
            Cost = cost;
            Error = error;
        }

        /// <summary>What it is.</summary>
        public string Title { get; }

        /// <summary>GPU ms per simulated second.</summary>
        public SampleStatistics Cost { get; }

        /// <summary>The error.</summary>
        public SampleStatistics Error { get; }
    }
}
