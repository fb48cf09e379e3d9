using System.Collections.Generic;
using System.Linq;
using System;
using Headless.Shaders;
using Headless.Vulkan;
using UnityEngine.Rendering;
using UnityEngine;
using MeshAttribute = UnityEngine.Rendering.VertexAttribute;

namespace Headless.Engine;

/// <summary>Fits a mesh's vertex streams to the inputs of a vertex shader.</summary>
internal static class VertexBinding
{
    private const int ZeroSlot = 6;
    private const int OneSlot = 7;
    private static DeviceBuffer? constants;

    /// <summary>Text that is equal for equal layouts.</summary>
    public static string Key(Mesh? mesh) => mesh is null
        ? string.Empty
        : string.Concat(mesh.Vertices.Attributes.Select(a => $"{(int)a.attribute}:{(int)a.format}:{a.dimension}:{a.stream};"));

    public static (VertexStream[] Streams, Headless.Vulkan.VertexAttribute[] Attributes) Describe(PassVariant variant, Mesh? mesh)
    {
        var streams = new List<VertexStream>();
        var attributes = new List<Headless.Vulkan.VertexAttribute>();
        foreach (VertexInput input in variant.Inputs)
        {
            MeshAttribute attribute = Attribute(input.Semantic);
            int index = mesh?.Vertices.Find(attribute) ?? -1;
            if (index >= 0)
            {
                VertexAttributeDescriptor d = mesh!.Vertices.Attributes[index];
                Add(streams, new VertexStream(d.stream, mesh.Vertices.Stride(d.stream)));
                attributes.Add(new Headless.Vulkan.VertexAttribute(input.Location, Format(d, mesh), mesh.Vertices.Offset(attribute), d.stream));
            }
            else
            {
                // A missing color is white, everything else zero.
                int slot = attribute == MeshAttribute.Color ? OneSlot : ZeroSlot;
                Add(streams, new VertexStream(slot, 0));
                attributes.Add(new Headless.Vulkan.VertexAttribute(input.Location, input.Integer ? GpuVertexFormat.UInt4 : GpuVertexFormat.Float4, 0, slot));
            }
        }

        return ([.. streams], [.. attributes]);
    }

    public static void SetBuffers(CommandRecorder recorder, PassVariant variant, Mesh? mesh)
    {
        foreach (VertexInput input in variant.Inputs)
        {
            MeshAttribute attribute = Attribute(input.Semantic);
            int index = mesh?.Vertices.Find(attribute) ?? -1;
            if (index >= 0)
            {
                int stream = mesh!.Vertices.Attributes[index].stream;
                recorder.SetVertexBuffer(stream, mesh.Device.VertexBuffers[stream].Gpu);
            }
            else
            {
                bool white = attribute == MeshAttribute.Color;
                recorder.SetVertexBuffer(white ? OneSlot : ZeroSlot, Constants.Gpu, white ? 16 : 0);
            }
        }
    }

    /// <summary>Makes the constant attributes; before drawing begins.</summary>
    public static void Prepare() => _ = Constants;

    public static void Reset() => constants = null;

    private static DeviceBuffer Constants
    {
        get
        {
            if (constants is null)
            {
                constants = new DeviceBuffer("Default vertex attributes", 8, 4, BufferUse.Vertex);
                float[] values = [0f, 0f, 0f, 0f, 1f, 1f, 1f, 1f];
                GraphicsDevice.Recorder.UpdateBuffer(constants.Gpu, 0, System.Runtime.InteropServices.MemoryMarshal.AsBytes(values.AsSpan()));
            }

            return constants;
        }
    }

    private static void Add(List<VertexStream> streams, VertexStream stream)
    {
        if (!streams.Contains(stream))
        {
            streams.Add(stream);
        }
    }

    private static MeshAttribute Attribute(string semantic)
    {
        string name = semantic.TrimEnd('0', '1', '2', '3', '4', '5', '6', '7', '8', '9');
        int index = name.Length < semantic.Length ? int.Parse(semantic[name.Length..], System.Globalization.CultureInfo.InvariantCulture) : 0;
        return name switch
        {
            "POSITION" or "SV_POSITION" => MeshAttribute.Position,
            "NORMAL" => MeshAttribute.Normal,
            "TANGENT" => MeshAttribute.Tangent,
            "COLOR" => MeshAttribute.Color,
            "TEXCOORD" => MeshAttribute.TexCoord0 + Math.Min(index, 7),
            "BLENDWEIGHT" or "BLENDWEIGHTS" => MeshAttribute.BlendWeight,
            "BLENDINDICES" => MeshAttribute.BlendIndices,
            _ => throw new NotSupportedException($"A vertex shader reads the semantic {semantic}, which no mesh has."),
        };
    }

    private static GpuVertexFormat Format(VertexAttributeDescriptor d, Mesh mesh) => (d.format, d.dimension) switch
    {
        (VertexAttributeFormat.Float32, 1) => GpuVertexFormat.Float1,
        (VertexAttributeFormat.Float32, 2) => GpuVertexFormat.Float2,
        (VertexAttributeFormat.Float32, 3) => GpuVertexFormat.Float3,
        (VertexAttributeFormat.Float32, 4) => GpuVertexFormat.Float4,
        (VertexAttributeFormat.Float16, 2) => GpuVertexFormat.Half2,
        (VertexAttributeFormat.Float16, 4) => GpuVertexFormat.Half4,
        (VertexAttributeFormat.UNorm8, 4) => GpuVertexFormat.UNorm8x4,
        (VertexAttributeFormat.UInt32 or VertexAttributeFormat.SInt32, 1) => GpuVertexFormat.UInt1,
        (VertexAttributeFormat.UInt32 or VertexAttributeFormat.SInt32, 2) => GpuVertexFormat.UInt2,
        (VertexAttributeFormat.UInt32 or VertexAttributeFormat.SInt32, 3) => GpuVertexFormat.UInt3,
        (VertexAttributeFormat.UInt32 or VertexAttributeFormat.SInt32, 4) => GpuVertexFormat.UInt4,
        _ => throw new NotSupportedException($"Mesh '{mesh.name}': vertex attribute {d} can't be drawn on this device: use Float32, Float16 or UNorm8."),
    };
}
