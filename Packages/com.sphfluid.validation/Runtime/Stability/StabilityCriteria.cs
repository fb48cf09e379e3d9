namespace SphFluid.Validation
{
    /// <summary>What a run is judged by. SI, simulation space; zero leaves a criterion out.</summary>
    public sealed class StabilityCriteria
    {
        /// <summary>The run's constants.</summary>
        public FluidSolverSettings Settings;

        /// <summary>v_ref [m/s]: the fastest that the scene itself moves.</summary>
        public double ReferenceSpeed;

        /// <summary>Least energy that growth is compared with [J], for scenes at rest.</summary>
        public double EnergyScale;

        /// <summary>Time from which the end of the run is judged [s].</summary>
        public double SettledFrom;

        /// <summary>Largest v_rms of a scene that comes to rest [m/s]; zero: it need not.</summary>
        public double RestSpeed;

        /// <summary>Height of the column at rest density above the domain's lower face [m]; zero: there is no column.</summary>
        public double Depth;

        /// <summary>Height of a wall's upper face [m] that liquid comes to from above; not a number: there is no such wall.</summary>
        public double WallTop = double.NaN;

        /// <summary>Whether nothing outside acts on the liquid, so that its momentum stays.</summary>
        public bool Closed;
    }
}
