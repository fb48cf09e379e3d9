using UnityEngine;

namespace SphFluid
{
    /// <summary>Property ids of the shaders in Shaders/Surface/Sparse.</summary>
    static class SparseShaderIds
    {
        public static readonly int BlockTable = Shader.PropertyToID("_BlockTable");
        public static readonly int BlockList = Shader.PropertyToID("_BlockList");
        public static readonly int BlockSamples = Shader.PropertyToID("_BlockSamples");
        public static readonly int BlockRanges = Shader.PropertyToID("_BlockRanges");
        public static readonly int SurfaceCounters = Shader.PropertyToID("_SurfaceCounters");
        public static readonly int RoundArguments = Shader.PropertyToID("_RoundArguments");
        public static readonly int SurfaceParticles = Shader.PropertyToID("_SurfaceParticles");
    }
}
