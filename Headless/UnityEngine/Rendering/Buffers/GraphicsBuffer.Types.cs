using System.Runtime.InteropServices;
using System;

namespace UnityEngine;

public sealed partial class GraphicsBuffer
{
    [Flags]
    public enum Target
    {
        Vertex = 1,
        Index = 2,
        CopySource = 4,
        CopyDestination = 8,
        Structured = 16,
        Raw = 32,
        Append = 64,
        Counter = 128,
        IndirectArguments = 256,
        Constant = 512,
    }

    [Flags]
    public enum UsageFlags
    {
        None = 0,
        LockBufferForWrite = 1,
    }

    [StructLayout(LayoutKind.Sequential)]
    public struct IndirectDrawArgs
    {
        public const int size = 16;

        public uint vertexCountPerInstance { get; set; }
        public uint instanceCount { get; set; }
        public uint startVertex { get; set; }
        public uint startInstance { get; set; }
    }

    [StructLayout(LayoutKind.Sequential)]
    public struct IndirectDrawIndexedArgs
    {
        public const int size = 20;

        public uint indexCountPerInstance { get; set; }
        public uint instanceCount { get; set; }
        public uint startIndex { get; set; }
        public uint baseVertexIndex { get; set; }
        public uint startInstance { get; set; }
    }
}
