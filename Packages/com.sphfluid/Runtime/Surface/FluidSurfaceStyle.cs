namespace SphFluid
{
    /// <summary>What is drawn of the marching-cubes grid: two of the three steps of Fig. 12 of the thesis.</summary>
    public enum FluidSurfaceStyle
    {
        /// <summary>The liquid's surface: the triangles of marching cubes.</summary>
        MarchingCubes = 0,

        /// <summary>The cubes of the grid with at least one vertex inside the liquid, to see how fine the grid is.</summary>
        Cubes = 1,
    }
}
