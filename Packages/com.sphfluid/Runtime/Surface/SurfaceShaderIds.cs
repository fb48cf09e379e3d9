using UnityEngine;

namespace SphFluid
{
    /// <summary>Property ids of the shaders in Shaders/Surface.</summary>
    static class SurfaceShaderIds
    {
        public static readonly int MCGrid = Shader.PropertyToID("_MCGrid");
        public static readonly int MCTables = Shader.PropertyToID("_MCTables");
        public static readonly int MCDensityScale = Shader.PropertyToID("_MCDensityScale");
        public static readonly int MCWallCompletion = Shader.PropertyToID("_MCWallCompletion");
        public static readonly int SurfaceVertexCount = Shader.PropertyToID("_SurfaceVertexCount");
        public static readonly int SurfaceVertices = Shader.PropertyToID("_SurfaceVertices");
        public static readonly int SurfaceIndices = Shader.PropertyToID("_SurfaceIndices");
        public static readonly int SurfaceVertexCapacity = Shader.PropertyToID("_SurfaceVertexCapacity");
    }
}
