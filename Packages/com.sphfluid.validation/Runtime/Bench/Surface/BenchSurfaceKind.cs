namespace SphFluid.Validation
{
    /// <summary>What a frame of the benchmark draws.</summary>
    public enum BenchSurfaceKind
    {
        /// <summary>Nothing.</summary>
        None,

        /// <summary>The particles as textured squares.</summary>
        Particles,

        /// <summary>The thesis's surface: a field over the whole grid, marching cubes in the geometry shader.</summary>
        Geometry,

        /// <summary>The same field, marching cubes in a compute shader over the whole grid, drawn from its buffer.</summary>
        DenseCompute,

        /// <summary>Field and marching cubes only in blocks that hold the surface.</summary>
        Sparse,

        /// <summary>The same, drawn as clear water.</summary>
        Water,

        /// <summary>That, and spray, foam and bubbles.</summary>
        Whitewater,
    }
}
