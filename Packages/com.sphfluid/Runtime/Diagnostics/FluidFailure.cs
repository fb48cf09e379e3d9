namespace SphFluid
{
    /// <summary>
    /// How a particle liquid goes wrong, by the names of failure-modes.md in the documentation of com.sphfluid.validation.
    /// </summary>
    public enum FluidFailure
    {
        /// <summary>Positions or velocities are not finite numbers.</summary>
        NonFinite,
        /// <summary>The liquid gains energy that nothing gave it.</summary>
        EnergyGrowth,
        /// <summary>Particles are outside the domain.</summary>
        Escaped,
        /// <summary>Suction draws particles into clumps.</summary>
        TensileClumping,
        /// <summary>A wide kernel lets particles pair.</summary>
        Pairing,
        /// <summary>Density and force by different kernels feed energy in: a liquid at rest boils.</summary>
        KernelMismatch,
        /// <summary>Particles at surfaces and walls find too little density.</summary>
        DensityDeficiency,
        /// <summary>A particle does not count itself in its density.</summary>
        SelfTermMissing,
        /// <summary>Particles in one place.</summary>
        CoincidentParticles,
        /// <summary>The time step is too long for the speed of sound.</summary>
        TimeStepTooLong,
        /// <summary>The time step is too long for the viscosity.</summary>
        ViscosityTooStiff,
        /// <summary>The viscosity that acts is the method's, not the liquid's.</summary>
        NumericalViscosity,
        /// <summary>Depth compresses the liquid: it loses volume.</summary>
        DeepTankLoss,
        /// <summary>Particles move so far in a step that they cross thin walls.</summary>
        Tunnelling,
        /// <summary>Particles stick to walls or stack at them.</summary>
        WallStacking,
        /// <summary>A limit on accelerations acts: momentum is lost.</summary>
        ClampActs,
        /// <summary>Something holds more than it can: neighbours, cells.</summary>
        Overflow,
        /// <summary>Liquid starts inside a body or other liquid.</summary>
        OverlappingStart,
        /// <summary>A particle feels another that does not feel it.</summary>
        AsymmetricPairs,
        /// <summary>The neighbour grid is not that of the present positions.</summary>
        StaleGrid,
    }
}
