namespace SphFluid
{
    /// <summary>What a force takes along in the sort, besides places, velocities and densities.</summary>
    internal interface ICarriedBuffers
    {
        /// <summary>
        /// 16 bytes a particle, in the order of the last sort; the last four are its <see cref="FluidParticle.DensityOffset"/>.
        /// </summary>
        FluidBuffer Carried { get; }

        /// <summary>Where the next sort puts them; the two are exchanged behind it.</summary>
        FluidBuffer Sorted { get; }
    }
}
