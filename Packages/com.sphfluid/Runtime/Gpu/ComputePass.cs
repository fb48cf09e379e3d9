using Unity.Profiling;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// A block of the work on the GPU: kernels of one compute shader under one profiler marker. XPass.cs records X.compute and is tested by
    /// XTests.cs, at the same path below Runtime, Shaders and Tests/Editor.
    /// </summary>
    internal abstract class ComputePass
    {
        private readonly FluidShaderSet shaders;
        private readonly string shader;
        private readonly ProfilerMarker marker;

        /// <param name="shaders">The shaders.</param>
        /// <param name="shader">Name of the pass, of its compute shader and of its marker.</param>
        protected ComputePass(FluidShaderSet shaders, string shader)
        {
            this.shaders = shaders;
            this.shader = shader;
            marker = ComputeKernel.CreateMarker(shader);
        }

        /// <summary>A property's id, for a constant of the pass.</summary>
        protected static int Id(string property) => Shader.PropertyToID(property);

        /// <summary>The kernel that has the shader's name.</summary>
        /// <exception cref="FluidDeviceException">The shader or the kernel is missing, or the device cannot run it.</exception>
        protected ComputeKernel Kernel() => Kernel(shader);

        /// <summary>A kernel of the shader.</summary>
        /// <exception cref="FluidDeviceException">The shader or the kernel is missing, or the device cannot run it.</exception>
        protected ComputeKernel Kernel(string kernel) => shaders.Kernel(shader, kernel);

        /// <summary>Opens the pass's sample of the profiler; disposing it closes the sample.</summary>
        protected CommandSample Sample(CommandBuffer cmd) => new CommandSample(cmd, marker);
    }
}
