namespace SphFluid.Validation
{
    /// <summary>What a point of the chart differs in from its case's base.</summary>
    public enum ChartFactor
    {
        /// <summary>In nothing: the base itself.</summary>
        Base,

        /// <summary>The particle spacing dx.</summary>
        Spacing,

        /// <summary>κ = R/dx.</summary>
        Support,

        /// <summary>The time step.</summary>
        TimeStep,

        /// <summary>The speed of sound.</summary>
        SoundSpeed,

        /// <summary>More than one of them.</summary>
        Several,
    }
}
