namespace SphFluid
{
    /// <summary>What becomes of the surface where the liquid touches a wall of the domain.</summary>
    public enum SurfaceWalls
    {
        /// <summary>It runs along the wall: the mesh is closed.</summary>
        Closed = 0,

        /// <summary>It ends at the wall: only the open surface is left, e.g. behind glass of one's own.</summary>
        Open = 1,
    }
}
