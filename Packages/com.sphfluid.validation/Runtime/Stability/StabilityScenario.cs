namespace SphFluid.Validation
{
    /// <summary>A cell of a map, ready to run and to be judged.</summary>
    public sealed class StabilityScenario
    {
        /// <summary>What to run; its length is cut to the steps that the run has.</summary>
        public CaseSetup Setup;

        /// <summary>What it is judged by.</summary>
        public StabilityCriteria Criteria;

        /// <summary>Length that the map asks for [s].</summary>
        public double RequestedDuration;

        /// <summary>Whether the run ends before the map's length.</summary>
        public bool IsCut => Setup.Duration < RequestedDuration * (1.0 - 1e-6);

        /// <summary>What a cut run's judgement says at its end.</summary>
        public const string CutText = "ended by its budget";

        /// <summary>Cuts the run to a number of steps; it is looked at fifty times, and the last quarter counts as its end.</summary>
        /// <param name="mostSteps">Most steps.</param>
        public StabilityScenario Cut(double mostSteps)
        {
            RequestedDuration = Setup.Duration;
            Setup.Duration = System.Math.Min(Setup.Duration, mostSteps * Setup.Settings.TimeStep);
            Setup.SampleInterval = System.Math.Max(Setup.Settings.TimeStep, Setup.Duration / 50.0);
            Criteria.SettledFrom = 0.75 * Setup.Duration;
            return this;
        }
    }
}
