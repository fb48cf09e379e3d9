namespace Headless.Vulkan;

/// <summary>What the open device can do; sizes in bytes, counts in elements.</summary>
public sealed record GpuLimits
{
    /// <summary>Largest range of a storage buffer that a shader can see.</summary>
    public required long MaxStorageBufferRange { get; init; }

    /// <summary>Largest constant buffer.</summary>
    public required long MaxUniformBufferRange { get; init; }

    /// <summary>Largest single memory allocation.</summary>
    public required long MaxAllocationSize { get; init; }

    /// <summary>Device-local memory: the largest heap, of which smaller ones may be windows.</summary>
    public required long DeviceMemory { get; init; }

    /// <summary>Threads in one compute group.</summary>
    public required int MaxComputeGroupInvocations { get; init; }

    /// <summary>Largest group size per dimension.</summary>
    public required (int X, int Y, int Z) MaxComputeGroupSize { get; init; }

    /// <summary>Groups per dimension of one dispatch.</summary>
    public required (uint X, uint Y, uint Z) MaxGroupCount { get; init; }

    /// <summary>Group-shared memory of one compute group.</summary>
    public required int MaxSharedMemory { get; init; }

    /// <summary>Storage buffers that one shader stage can bind.</summary>
    public required int MaxStorageBuffersPerStage { get; init; }

    /// <summary>Storage images that one shader stage can bind.</summary>
    public required int MaxStorageImagesPerStage { get; init; }

    /// <summary>Constant buffers that one pipeline can bind.</summary>
    public required int MaxUniformBuffersPerPipeline { get; init; }

    /// <summary>Largest side of a 2D texture.</summary>
    public required int MaxTexture2D { get; init; }

    /// <summary>Largest side of a 3D texture.</summary>
    public required int MaxTexture3D { get; init; }

    /// <summary>Layers of an array texture.</summary>
    public required int MaxTextureLayers { get; init; }

    /// <summary>Color targets bound at once.</summary>
    public required int MaxColorTargets { get; init; }

    /// <summary>Whether pipelines may have a geometry stage.</summary>
    public required bool GeometryShader { get; init; }

    /// <summary>Vertices that one geometry shader invocation can emit; 0 without the stage.</summary>
    public required int MaxGeometryOutputVertices { get; init; }

    /// <summary>Whether vertex and geometry shaders may write buffers.</summary>
    public required bool VertexStageWrites { get; init; }

    /// <summary>Whether timestamps work on the device's queue.</summary>
    public required bool Timestamps { get; init; }

    /// <summary>Sample counts that color and depth targets both support, as a bit mask (1 | 4 | ...).</summary>
    public required int SampleCounts { get; init; }

    /// <summary>Alignment of a storage buffer's bound offset.</summary>
    public required int StorageBufferOffsetAlignment { get; init; }
}
