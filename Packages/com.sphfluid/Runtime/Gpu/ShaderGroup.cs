using System;
using System.Collections.Generic;

namespace SphFluid
{
    /// <summary>
    /// The shaders of a part of the package, by name, and the most that any of their kernels asks of a device. The numbers are counted in
    /// what Microsoft's compiler makes of the kernels, and the checks of the source tree hold them against it.
    /// </summary>
    internal sealed class ShaderGroup
    {
        /// <summary>The sparse surface.</summary>
        public static readonly ShaderGroup Surface = new ShaderGroup("the surface", "Shaders/Surface/Sparse",
            groupThreads: 256, buffers: 8, writableBuffers: 4, groupMemory: 12464, vertexBuffers: 0,
            "ClearSurfaceBlocks", "PrepareSurfaceParticles", "ListSpray", "ListSurfaceBlocks", "SampleBlocks", "CountBlocks",
            "SurfaceDrawArguments",
            "EmitBlocks", "WriteSurfaceMesh");

        /// <summary>What draws particles and the sparse surface.</summary>
        public static readonly ShaderGroup Drawing = new ShaderGroup("the drawing", "Shaders/Rendering",
            groupThreads: 0, buffers: 0, writableBuffers: 0, groupMemory: 0, vertexBuffers: 1,
            "SPH Fluid/Particles", "SPH Fluid/Surface", "SPH Fluid/Water", "Hidden/SPH Fluid/Water Thickness",
            "Hidden/SPH Fluid/Water Depth", "Hidden/SPH Fluid/Caustics",
            "Hidden/SPH Fluid/Water From Within", "Hidden/SPH Fluid/Spray", "Hidden/SPH Fluid/Spray Behind Water",
            "Hidden/SPH Fluid/Shadow Constants");

        /// <summary>What a running simulation goes by.</summary>
        public static readonly ShaderGroup Simulation = new ShaderGroup("the simulation", "Shaders/Simulation",
            groupThreads: 256, buffers: 4, writableBuffers: 2, groupMemory: 4100, vertexBuffers: 0,
            "MeasureSpeeds");

        /// <summary>Measurements of a whole liquid.</summary>
        public static readonly ShaderGroup Diagnostics = new ShaderGroup("the diagnostics", "Shaders/Diagnostics",
            groupThreads: 256, buffers: 5, writableBuffers: 1, groupMemory: 4096, vertexBuffers: 0,
            "MeasureStatistics");

        /// <summary>The gradient correction, a force of the method Standard, also where the force on walls is summed.</summary>
        public static readonly ShaderGroup GradientCorrection = new ShaderGroup("the gradient correction",
            "Shaders/Solver/Standard/GradientCorrection",
            groupThreads: 64, buffers: 14, writableBuffers: 6, groupMemory: 6144, vertexBuffers: 0)
        { Keyword = "FLUID_GRADIENT_CORRECTION" };

        /// <summary>The sums of what the liquid gives to its walls.</summary>
        public static readonly ShaderGroup WallForces = new ShaderGroup("the force on walls", "Shaders/Solver/WallForces",
            groupThreads: 64, buffers: 13, writableBuffers: 6, groupMemory: 11520, vertexBuffers: 0,
            "PlaceWallPatches")
        { Keyword = "FLUID_WALL_FORCES" };

        /// <summary>Spray, foam and bubbles.</summary>
        public static readonly ShaderGroup Whitewater = new ShaderGroup("whitewater", "Shaders/Whitewater",
            groupThreads: 256, buffers: 7, writableBuffers: 3, groupMemory: 4096, vertexBuffers: 1,
            "WhitewaterPotentials", "WhitewaterMotion", "WhitewaterList", "Hidden/SPH Fluid/Whitewater",
            "Hidden/SPH Fluid/Whitewater Behind Water");

        public ShaderGroup(string part, string folder, int groupThreads, int buffers, int writableBuffers, int groupMemory,
            int vertexBuffers,
            params string[] shaders)
        {
            Part = part;
            Folder = folder;
            GroupThreads = groupThreads;
            Buffers = buffers;
            WritableBuffers = writableBuffers;
            GroupMemory = groupMemory;
            VertexBuffers = vertexBuffers;
            Shaders = shaders;
        }

        /// <summary>This group, which cannot do without another that it shares with others.</summary>
        public ShaderGroup With(ShaderGroup shared) =>
            new ShaderGroup(Part, Folder, GroupThreads, Buffers, WritableBuffers, GroupMemory, VertexBuffers,
            new List<string>(Shaders).ToArray())
            { Shared = shared };

        /// <summary>The group that this one cannot do without; null for none.</summary>
        public ShaderGroup Shared { get; private set; }

        /// <summary>Name in messages.</summary>
        public string Part { get; }

        /// <summary>Folder of the kernels below the package; of nested ones the inner counts.</summary>
        public string Folder { get; }

        /// <summary>Optional physics of other groups' kernels: variants with this keyword count here, not there. Null for none.</summary>
        public string Keyword { get; private set; }

        /// <summary>Whether it draws by a geometry shader.</summary>
        public bool NeedsGeometryShaders { get; set; }

        /// <summary>Names: of compute shaders their files', of shaders what they declare.</summary>
        public IReadOnlyList<string> Shaders { get; }

        /// <summary>Those, and the names of <see cref="Shared"/>.</summary>
        public IReadOnlyList<string> AllShaders
        {
            get
            {
                var all = new List<string>(Shaders);
                if (Shared != null) all.AddRange(Shared.Shaders);
                return all;
            }
        }

        /// <summary>Threads of a group.</summary>
        public int GroupThreads { get; }

        /// <summary>Buffers that a kernel reads or writes.</summary>
        public int Buffers { get; }

        /// <summary>Those that it writes; Direct3D 11.0 has 8. Unity does not say what a device has.</summary>
        public int WritableBuffers { get; }

        /// <summary>
        /// Bytes that the threads of a group share; Vulkan and OpenGL ES 3.1 promise 16,384. Unity does not say what a device has.
        /// </summary>
        public int GroupMemory { get; }

        /// <summary>Buffers that a vertex shader reads.</summary>
        public int VertexBuffers { get; }

        /// <summary>Limits of a device with compute shaders that are too small, a sentence each.</summary>
        public IEnumerable<string> Shortfalls(DeviceCapabilities device)
        {
            int threads = Math.Max(GroupThreads, Shared?.GroupThreads ?? 0), buffers = Math.Max(Buffers, Shared?.Buffers ?? 0);
            if (device.GroupThreads < threads)
            {
                yield return $"{device.Name} runs compute groups of {device.GroupThreads} threads; {Part} needs {threads}.";
            }
            if (device.ComputeBuffers < buffers)
            {
                yield return $"{device.Name} binds {device.ComputeBuffers} buffers to a compute shader; {Part} needs {buffers}.";
            }
            if (device.VertexBuffers < VertexBuffers)
            {
                yield return $"{device.Name} binds {device.VertexBuffers} buffers to a vertex shader; {Part} needs {VertexBuffers}.";
            }
            if (NeedsGeometryShaders && !device.GeometryShaders)
            {
                yield return $"{device.Name} has no geometry shaders, which {Part} is made with.";
            }
        }
    }
}
