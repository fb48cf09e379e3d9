using System.Collections.Generic;

namespace SphFluid.Laboratory
{
    /// <summary>For measurements only: how the product's marching cubes number corners and edges.</summary>
    public static class CubeNumbering
    {
        /// <summary>The two corners of each of the 12 edges, one pair after the other.</summary>
        public static IReadOnlyList<int> EdgeCorners => MarchingCubesTables.EdgeCorners;
    }
}
