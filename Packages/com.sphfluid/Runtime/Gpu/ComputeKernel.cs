using System.Collections.Generic;
using Unity.Profiling;
using Unity.Profiling.LowLevel;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// A kernel of a compute shader: found by name, its support asked, its group size read from the shader.
    /// Everything is recorded into the caller's command buffer: a compute shader asset is shared by all simulations,
    /// so each dispatch is preceded by its own parameters.
    /// </summary>
    public sealed class ComputeKernel
    {
        /// <summary>Groups a dispatch may have in one dimension; MAX_GROUPS in Shaders/Gpu/FluidTypes.hlsl.</summary>
        public const int MaxGroups = 65535;

        private readonly ComputeShader shader;
        private readonly int index;
        private readonly Dictionary<string, LocalKeyword> keywords = new Dictionary<string, LocalKeyword>();
        private readonly Dictionary<string, bool> declaredKeywords = new Dictionary<string, bool>();

        /// <summary>Finds a kernel.</summary>
        /// <param name="shader">The compute shader.</param>
        /// <param name="name">The kernel's name.</param>
        /// <exception cref="FluidDeviceException">The shader is missing, has no such kernel, or the device cannot run it.</exception>
        public ComputeKernel(ComputeShader shader, string name)
        {
            if (shader == null)
            {
                throw new FluidDeviceException($"No compute shader is assigned for '{name}'. Assign it in the fluid shader set.");
            }

            if (!SystemInfo.supportsComputeShaders)
            {
                throw new FluidDeviceException(
                    $"{SystemInfo.graphicsDeviceName} ({SystemInfo.graphicsDeviceType}) has no compute shaders; the fluid needs them.");
            }

            if (!shader.HasKernel(name))
            {
                throw new FluidDeviceException(
                    $"The compute shader '{shader.name}' has no kernel '{name}', or did not compile. Reimport it and see the console.");
            }

            this.shader = shader;
            Name = name;
            index = shader.FindKernel(name);
            if (!shader.IsSupported(index))
            {
                throw new FluidDeviceException(
                    $"{SystemInfo.graphicsDeviceName} ({SystemInfo.graphicsDeviceType}) cannot run the kernel '{name}' of " +
                    $"'{shader.name}'.");
            }

            shader.GetKernelThreadGroupSizes(index, out uint x, out uint y, out uint z);
            GroupSize = new Vector3Int((int)x, (int)y, (int)z);
        }

        /// <summary>The kernel's name.</summary>
        public string Name { get; }

        /// <summary>Threads of a group, as the shader declares them.</summary>
        public Vector3Int GroupSize { get; }

        /// <summary>Dispatches recorded by all kernels since the program started: benchmarks count by its difference.</summary>
        [OutlivesPlay("only differences are read")] public static long DispatchesRecorded { get; private set; }

        /// <summary>A profiler marker that measures GPU time where the device can.</summary>
        /// <param name="name">Name of the block.</param>
        /// <returns>The marker.</returns>
        public static ProfilerMarker CreateMarker(string name)
        {
            return new ProfilerMarker(ProfilerCategory.Render, name, MarkerFlags.SampleGPU);
        }

        /// <summary>Records a buffer for the next dispatch.</summary>
        /// <param name="cmd">Command buffer.</param>
        /// <param name="id">Property id.</param>
        /// <param name="buffer">The buffer.</param>
        public void SetBuffer(CommandBuffer cmd, int id, GraphicsBuffer buffer)
        {
            cmd.SetComputeBufferParam(shader, index, id, buffer);
        }

        /// <summary>Records a buffer for the next dispatch, by the name that kernels read it by.</summary>
        internal void Set(CommandBuffer cmd, FluidBuffer buffer) => SetBuffer(cmd, buffer.Id, buffer);

        /// <summary>Records a buffer for the next dispatch, by the name that kernels write it by.</summary>
        internal void SetOut(CommandBuffer cmd, FluidBuffer buffer) => SetBuffer(cmd, buffer.OutId, buffer);

        /// <summary>Records a part of a buffer that the kernel reads.</summary>
        internal void Set(CommandBuffer cmd, BufferRange range)
        {
            Set(cmd, range.Buffer);
            SetInt(cmd, range.BeginId, range.Begin);
        }

        /// <summary>Records a part of a buffer that the kernel writes.</summary>
        internal void SetOut(CommandBuffer cmd, BufferRange range)
        {
            SetOut(cmd, range.Buffer);
            SetInt(cmd, range.BeginId, range.Begin);
        }

        /// <summary>Records a number for the next dispatch.</summary>
        /// <param name="cmd">Command buffer.</param>
        /// <param name="id">Property id.</param>
        /// <param name="value">The value.</param>
        public void SetFloat(CommandBuffer cmd, int id, float value)
        {
            cmd.SetComputeFloatParam(shader, id, value);
        }

        /// <summary>Records an integer for the next dispatch.</summary>
        /// <param name="cmd">Command buffer.</param>
        /// <param name="id">Property id.</param>
        /// <param name="value">The value.</param>
        public void SetInt(CommandBuffer cmd, int id, int value)
        {
            cmd.SetComputeIntParam(shader, id, value);
        }

        /// <summary>Records a switch for the next dispatch: 1 or 0.</summary>
        /// <param name="cmd">Command buffer.</param>
        /// <param name="id">Property id.</param>
        /// <param name="value">The value.</param>
        public void SetBool(CommandBuffer cmd, int id, bool value)
        {
            cmd.SetComputeIntParam(shader, id, value ? 1 : 0);
        }

        /// <summary>Whether the shader has variants by a keyword.</summary>
        /// <param name="keyword">The keyword.</param>
        internal bool HasKeyword(string keyword)
        {
            if (!declaredKeywords.TryGetValue(keyword, out bool isDeclared))
            {
                isDeclared = TryFindKeyword(keyword, out _);
                declaredKeywords.Add(keyword, isDeclared);
            }

            return isDeclared;
        }

        /// <summary>Records a keyword for the next dispatch: which variant of the shader it takes.</summary>
        /// <param name="cmd">Command buffer.</param>
        /// <param name="keyword">A keyword that the shader declares by multi_compile_local.</param>
        /// <param name="value">Whether it is on.</param>
        /// <exception cref="FluidDeviceException">The shader does not declare the keyword.</exception>
        public void SetKeyword(CommandBuffer cmd, string keyword, bool value)
        {
            if (!keywords.TryGetValue(keyword, out LocalKeyword declared))
            {
                declared = FindKeyword(keyword);
                keywords.Add(keyword, declared);
            }

            cmd.SetKeyword(shader, declared, value);
        }

        /// <summary>Records integers for the next dispatch.</summary>
        /// <param name="cmd">Command buffer.</param>
        /// <param name="id">Property id.</param>
        /// <param name="values">The values; not kept.</param>
        public void SetInts(CommandBuffer cmd, int id, int[] values)
        {
            cmd.SetComputeIntParams(shader, id, values);
        }

        /// <summary>Records a vector for the next dispatch.</summary>
        /// <param name="cmd">Command buffer.</param>
        /// <param name="id">Property id.</param>
        /// <param name="value">The value.</param>
        public void SetVector(CommandBuffer cmd, int id, Vector4 value)
        {
            cmd.SetComputeVectorParam(shader, id, value);
        }

        /// <summary>Records a matrix for the next dispatch.</summary>
        /// <param name="cmd">Command buffer.</param>
        /// <param name="id">Property id.</param>
        /// <param name="value">The value.</param>
        public void SetMatrix(CommandBuffer cmd, int id, in Matrix4x4 value)
        {
            cmd.SetComputeMatrixParam(shader, id, value);
        }

        /// <summary>Records a one-dimensional dispatch; the kernel finds its element by FlatIndex and guards the last group.</summary>
        /// <param name="cmd">Command buffer.</param>
        /// <param name="threads">Number of elements; none records nothing.</param>
        public void DispatchThreads(CommandBuffer cmd, int threads)
        {
            Vector2Int groups = SplitGroups(Groups(threads, GroupSize.x));
            Dispatch(cmd, groups.x, groups.y, 1);
        }

        /// <summary>Records a dispatch over a box of threads.</summary>
        /// <param name="cmd">Command buffer.</param>
        /// <param name="x">Threads along x.</param>
        /// <param name="y">Threads along y.</param>
        /// <param name="z">Threads along z.</param>
        public void DispatchThreads(CommandBuffer cmd, int x, int y, int z)
        {
            Dispatch(cmd, Groups(x, GroupSize.x), Groups(y, GroupSize.y), Groups(z, GroupSize.z));
        }

        /// <summary>Records a dispatch of as many groups as a buffer holds when it runs.</summary>
        /// <param name="cmd">Command buffer.</param>
        /// <param name="arguments">Groups along x, y and z, uint each; made for
        /// <see cref="GraphicsBuffer.Target.IndirectArguments"/>.</param>
        /// <param name="begin">Where they begin in it, in bytes.</param>
        public void DispatchIndirect(CommandBuffer cmd, GraphicsBuffer arguments, uint begin = 0)
        {
            cmd.DispatchCompute(shader, index, arguments, begin);
            DispatchesRecorded++;
        }

        /// <summary>Spreads groups over two dimensions: 65,538 groups become (65,535, 2), the last row partly idle.</summary>
        /// <param name="groups">Number of groups.</param>
        /// <returns>Groups along x and y.</returns>
        public static Vector2Int SplitGroups(int groups)
        {
            return groups <= MaxGroups
                ? new Vector2Int(groups, groups > 0 ? 1 : 0)
                : new Vector2Int(MaxGroups, Groups(groups, MaxGroups));
        }

        private bool TryFindKeyword(string keyword, out LocalKeyword found)
        {
            foreach (LocalKeyword declared in shader.keywordSpace.keywords)
            {
                if (declared.name == keyword)
                {
                    found = declared;
                    return true;
                }
            }

            found = default;
            return false;
        }

        private LocalKeyword FindKeyword(string keyword)
        {
            if (TryFindKeyword(keyword, out LocalKeyword found)) return found;

            throw new FluidDeviceException(
                $"The compute shader '{shader.name}' does not declare '{keyword}'. Add '#pragma multi_compile_local _ {keyword}' to it.");
        }

        private static int Groups(int threads, int size)
        {
            return (int)(((long)threads + size - 1) / size);
        }

        private void Dispatch(CommandBuffer cmd, int x, int y, int z)
        {
            if (x > MaxGroups || y > MaxGroups || z > MaxGroups)
            {
                throw new FluidDeviceException(
                    $"The kernel '{Name}' would need {x} x {y} x {z} groups; a dispatch holds {MaxGroups} along an axis. Use a coarser " +
                    "grid.");
            }

            if (x > 0 && y > 0 && z > 0)
            {
                cmd.DispatchCompute(shader, index, x, y, z);
                DispatchesRecorded++;
            }
        }
    }
}
