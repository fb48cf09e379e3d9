using UnityEngine;

namespace SphFluid
{
    /// <summary>Property ids of what several parts of the package read of a liquid.</summary>
    internal static class FluidShaderIds
    {
        public static readonly int GridIndices = Shader.PropertyToID("_GridIndices");
        public static readonly int Density = Shader.PropertyToID("_Density");
        public static readonly int ParticleCount = Shader.PropertyToID("_ParticleCount");
    }
}
