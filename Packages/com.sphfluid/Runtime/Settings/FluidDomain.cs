namespace SphFluid
{
    /// <summary>Where a liquid may go.</summary>
    public enum FluidDomain
    {
        /// <summary>Within a box, whose faces are walls or what <see cref="FluidBoundaries"/> say.</summary>
        Box,

        /// <summary>
        /// Wherever colliders let it, up to a farthest distance. There are no walls but colliders. Methods Standard and Robust.
        /// </summary>
        Open,
    }
}
