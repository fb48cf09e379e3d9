using Unity.Profiling;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// Vertices and indices of the present round's blocks, a group each, and their place in the buffers; lists blocks that the surface was found to
    /// reach besides (Shaders/Surface/Sparse/CountBlocks.compute).
    /// </summary>
    sealed class CountBlocksPass
    {
        const string Name = "CountBlocks";
        static readonly ProfilerMarker Marker = ComputeKernel.CreateMarker(Name);

        readonly ComputeKernel kernel;

        public CountBlocksPass(FluidShaderSet shaders)
        {
            kernel = shaders.Kernel("CountBlocks", Name);
        }

        public void Record(CommandBuffer cmd, in BlockPolygons input)
        {
            cmd.BeginSample(Marker);
            input.SetGlobals(cmd, kernel);
            kernel.DispatchIndirect(cmd, input.Blocks.RoundArguments);
            cmd.EndSample(Marker);
        }
    }
}
