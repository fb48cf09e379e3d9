namespace SphFluid
{
    /// <summary>How closely light is followed through clear water.</summary>
    public enum FluidWaterQuality
    {
        /// <summary>Bent once at the surface; where something hides what it would show, not at all.</summary>
        Fast,

        /// <summary>Followed through the nearest layer of water, and behind it, to what it meets.</summary>
        Balanced,

        /// <summary>Followed in small steps, and mirrored by the walls of a tank below the critical angle.</summary>
        Fine,
    }
}
