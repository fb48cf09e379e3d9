namespace SphFluid
{
    /// <summary>What is drawn of the marching-cubes grid: two of the three steps of Fig. 12 of the thesis.</summary>
    public enum FluidSurfaceStyle
    {
        /// <summary>The liquid's surface: the triangles of marching cubes.</summary>
        MarchingCubes = 0,

        /// <summary>
        /// The edges of the grid's cubes with at least one vertex inside the liquid: how fine the grid is, and what it
        /// holds.
        /// </summary>
        Cubes = 1,
    }
}
