namespace SphFluid
{
    /// <summary>How the liquid is brought to rest before the first frame. Standard method only.</summary>
    public enum FluidStartRelaxation
    {
        /// <summary>Not at all: particles start on their lattice, moved by the start jitter.</summary>
        None,

        /// <summary>Without gravity: particles that lie too near to each other or to a wall part.</summary>
        Packed,

        /// <summary>Under gravity: walls and colliders carry the liquid, compressed by its own weight.</summary>
        Hydrostatic,

        /// <summary>As Hydrostatic, but only as it was saved: the start takes no time, and liquid that was changed since is not relaxed.
        /// </summary>
        Saved,
    }
}
