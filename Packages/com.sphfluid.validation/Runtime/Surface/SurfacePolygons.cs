namespace SphFluid.Validation
{
    /// <summary>What turns a field into triangles.</summary>
    internal enum SurfacePolygons
    {
        /// <summary>Marching cubes with the package's tables.</summary>
        MarchingCubes,

        /// <summary>Dual marching cubes as first published.</summary>
        Dual,

        /// <summary>Dual marching cubes made a manifold.</summary>
        DualWithFlip,
    }
}
