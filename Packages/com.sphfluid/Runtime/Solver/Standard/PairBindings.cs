using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>ListedPairs.hlsl: neighbours and walls for the passes of forces.</summary>
    internal static class PairBindings
    {
        public static void Set(CommandBuffer cmd, ComputeKernel kernel, StandardState state)
        {
            CellBindings.SetSearch(cmd, kernel, state);
            CellBindings.SetWalls(cmd, kernel, state);
            state.List.Set(cmd, kernel);
            kernel.Set(cmd, state.Buffers.PositionTerms);
        }
    }
}
