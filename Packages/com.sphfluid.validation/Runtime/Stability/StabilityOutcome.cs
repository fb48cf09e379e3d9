namespace SphFluid.Validation
{
    /// <summary>The judgement of a run.</summary>
    public sealed class StabilityOutcome
    {
        /// <summary>How it went.</summary>
        public StabilityVerdict Verdict;

        /// <summary>What was wrong first.</summary>
        public StabilityCause Cause;

        /// <summary>The same with figures, and whether the run was cut short.</summary>
        public string Reason = "";

        /// <summary>When it failed [s]; not a number when it did not.</summary>
        public double TimeToFailure = double.NaN;

        /// <summary>Number of particles.</summary>
        public int Particles;

        /// <summary>Steps done.</summary>
        public long Steps;

        /// <summary>Whether the run ended before the map's length: it says less.</summary>
        public bool IsCut => Reason.Contains(StabilityScenario.CutText);
    }
}
