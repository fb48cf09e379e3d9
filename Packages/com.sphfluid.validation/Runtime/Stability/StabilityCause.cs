namespace SphFluid.Validation
{
    /// <summary>What was wrong with a run first.</summary>
    public enum StabilityCause
    {
        /// <summary>Nothing.</summary>
        None,

        /// <summary>Failed: a position or velocity is not a finite number.</summary>
        NotFinite,

        /// <summary>Failed: the energy grew beyond 1.05 of the start's without work.</summary>
        Energy,

        /// <summary>Failed: a particle is faster than three times the reference speed.</summary>
        Speed,

        /// <summary>Failed: more than 0.1 % of the particles are beyond a wall by half a spacing.</summary>
        Escape,

        /// <summary>Failed: the mean compression grew by more than 10 %.</summary>
        Compression,

        /// <summary>Degraded: what should be at rest moves.</summary>
        Restless,

        /// <summary>Degraded: more than 1 % of the particles have a neighbour within half a spacing.</summary>
        Clumped,

        /// <summary>Degraded: the column lost more height than its equation of state tells, and 2 %.</summary>
        Sunk,

        /// <summary>Degraded: the emergency limit cut accelerations, or particles were put back onto a face of the domain.</summary>
        Clamped,

        /// <summary>Degraded: the momentum of a closed system drifted by more than 1e-3.</summary>
        Drift,
    }
}
