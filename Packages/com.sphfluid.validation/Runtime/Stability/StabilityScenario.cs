namespace SphFluid.Validation
{
    /// <summary>A cell of a map, ready to run, and what is expected of it. SI, simulation space; zero leaves a criterion out.</summary>
    public sealed class StabilityScenario
    {
        /// <summary>What a cut run's outcome says at its end.</summary>
        public const string CutText = "ended by its budget";

        /// <summary>What to run; its length is cut to the steps that the run has.</summary>
        public CaseSetup Setup;

        /// <summary>Length that the map asks for [s].</summary>
        public double RequestedDuration;

        /// <summary>v_ref [m/s]: the fastest that the scene itself moves.</summary>
        public double ReferenceSpeed;

        /// <summary>Least energy that growth is compared with [J], for scenes at rest.</summary>
        public double EnergyScale;

        /// <summary>Time from which on the run should have settled [s].</summary>
        public double SettledFrom;

        /// <summary>Largest v_rms of a scene that comes to rest [m/s]; zero: it need not.</summary>
        public double RestSpeed;

        /// <summary>Height of the column at rest density above the domain's lower face [m]; zero: there is no column.</summary>
        public double Depth;

        /// <summary>Height of a wall's upper face [m] that liquid falls onto; not a number: there is no such wall.</summary>
        public double WallTop = double.NaN;

        /// <summary>Whether nothing outside acts on the liquid, so that its momentum stays.</summary>
        public bool Closed;

        /// <summary>Whether the run ends before the map's length.</summary>
        public bool IsCut => Setup.Duration < RequestedDuration * (1.0 - 1e-6);

        /// <summary>Cuts the run to a number of steps; it is sampled fifty times, and the last quarter counts as its end.</summary>
        /// <param name="mostSteps">Most steps.</param>
        public StabilityScenario Cut(double mostSteps)
        {
            RequestedDuration = Setup.Duration;
            Setup.Duration = System.Math.Min(Setup.Duration, mostSteps * Setup.Settings.TimeStep);
            Setup.SampleInterval = System.Math.Max(Setup.Settings.TimeStep, Setup.Duration / 50.0);
            SettledFrom = 0.75 * Setup.Duration;
            return this;
        }
    }
}
