namespace SphFluid
{
    /// <summary>What a <see cref="FluidVolume"/> fills.</summary>
    public enum FluidVolumeShape
    {
        /// <summary>A box round the transform, of its size.</summary>
        Box,

        /// <summary>The ellipsoid in that box; a sphere where its edges are equal.</summary>
        Sphere,

        /// <summary>The inside of a closed mesh.</summary>
        Mesh,

        /// <summary>The hollow of the colliders round the transform, up to a level.</summary>
        Vessel,
    }
}
