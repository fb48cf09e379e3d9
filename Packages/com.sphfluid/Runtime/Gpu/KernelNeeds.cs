using System.Collections.Generic;

namespace SphFluid
{
    /// <summary>
    /// The most that any kernel of a part of the package asks of a device. The numbers are counted in what Microsoft's compiler makes of the
    /// kernels, and the checks of the source tree hold them against it.
    /// </summary>
    internal sealed class KernelNeeds
    {
        public static readonly KernelNeeds Standard = new KernelNeeds("the Standard method", "Shaders/Solver/Standard",
            groupThreads: 256, buffers: 13, writableBuffers: 6, groupMemory: 1024, vertexBuffers: 0);

        public static readonly KernelNeeds Thesis = new KernelNeeds("the thesis method", "Shaders/Solver/Thesis",
            groupThreads: 1024, buffers: 7, writableBuffers: 3, groupMemory: 8192, vertexBuffers: 0);

        public static readonly KernelNeeds Surface = new KernelNeeds("the surface", "Shaders/Surface/Sparse",
            groupThreads: 256, buffers: 8, writableBuffers: 4, groupMemory: 14112, vertexBuffers: 0);

        public static readonly KernelNeeds GeometrySurface = new KernelNeeds("the thesis's surface", "Shaders/Surface",
            groupThreads: 256, buffers: 4, writableBuffers: 2, groupMemory: 0, vertexBuffers: 0);

        public static readonly KernelNeeds Drawing = new KernelNeeds("the drawing", "Shaders/Rendering",
            groupThreads: 0, buffers: 0, writableBuffers: 0, groupMemory: 0, vertexBuffers: 1);

        public static readonly KernelNeeds Diagnostics = new KernelNeeds("the diagnostics", "Shaders/Diagnostics",
            groupThreads: 256, buffers: 5, writableBuffers: 1, groupMemory: 4096, vertexBuffers: 0);

        KernelNeeds(string part, string folder, int groupThreads, int buffers, int writableBuffers, int groupMemory, int vertexBuffers)
        {
            Part = part;
            Folder = folder;
            GroupThreads = groupThreads;
            Buffers = buffers;
            WritableBuffers = writableBuffers;
            GroupMemory = groupMemory;
            VertexBuffers = vertexBuffers;
        }

        /// <summary>Name in messages.</summary>
        public string Part { get; }

        /// <summary>Folder of the kernels below the package; of nested ones the inner counts.</summary>
        public string Folder { get; }

        /// <summary>Threads of a group.</summary>
        public int GroupThreads { get; }

        /// <summary>Buffers that a kernel reads or writes.</summary>
        public int Buffers { get; }

        /// <summary>Those that it writes; Direct3D 11.0 has 8. Unity does not say what a device has.</summary>
        public int WritableBuffers { get; }

        /// <summary>Bytes that the threads of a group share; Vulkan and OpenGL ES 3.1 promise 16,384. Unity does not say what a device has.</summary>
        public int GroupMemory { get; }

        /// <summary>Buffers that a vertex shader reads.</summary>
        public int VertexBuffers { get; }

        /// <summary>What a device with compute shaders has too little of, a sentence each.</summary>
        public IEnumerable<string> Shortfalls(DeviceCapabilities device)
        {
            if (device.GroupThreads < GroupThreads)
                yield return $"{device.Name} runs compute groups of {device.GroupThreads} threads; {Part} needs {GroupThreads}.";
            if (device.ComputeBuffers < Buffers)
                yield return $"{device.Name} binds {device.ComputeBuffers} buffers to a compute shader; {Part} needs {Buffers}.";
            if (device.VertexBuffers < VertexBuffers)
                yield return $"{device.Name} binds {device.VertexBuffers} buffers to a vertex shader; {Part} needs {VertexBuffers}.";
        }
    }
}
