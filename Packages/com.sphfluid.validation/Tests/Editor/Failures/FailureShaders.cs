using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Shaders of the failure experiments.</summary>
    internal static class FailureShaders
    {
        /// <summary>The thesis method and the statistics; destroy it after use.</summary>
        public static FluidShaderSet Create() => TestShaders.CreateSet();

        /// <summary>What the neighbour loop finds.</summary>
        public static ComputeShader Audit() =>
            TestAssets.Load<ComputeShader>("Packages/com.sphfluid.validation/Runtime/Measure/NeighbourAudit.compute");
    }
}
