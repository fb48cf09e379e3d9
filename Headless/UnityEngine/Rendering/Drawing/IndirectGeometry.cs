using System;
using Headless.Vulkan;
using UnityEngine;

namespace Headless.Engine;

/// <summary>Draws whose counts stand in a GPU buffer: procedural, procedural with indices, or of a mesh.</summary>
internal sealed class IndirectGeometry(
    MeshTopology topology, DeviceBuffer arguments, long offset, int commands, DeviceBuffer? indexBuffer, Mesh? mesh) : DrawGeometry
{
    private const int PlainSize = GraphicsBuffer.IndirectDrawArgs.size;
    private const int IndexedSize = GraphicsBuffer.IndirectDrawIndexedArgs.size;

    public override Mesh? Mesh => mesh;
    public override MeshTopology Topology => topology;
    private bool Indexed => indexBuffer is not null || mesh is not null;

    public override bool Prepare()
    {
        if (topology == MeshTopology.Quads)
        {
            throw new NotSupportedException("Quads can't be drawn indirectly on this device: use triangles.");
        }

        long end = offset + ((long)commands * (Indexed ? IndexedSize : PlainSize));
        if (!arguments.IsValid || end > arguments.ByteSize)
        {
            Debug.LogError($"Indirect draw: {commands} commands at byte {offset} need {end} bytes of buffer '{arguments.Name}', which {(arguments.IsValid ? $"has {arguments.ByteSize}" : "has been released")}.");
            return false;
        }

        if (BufferViewCheck.NotArguments(arguments) is { } problem)
        {
            Debug.LogError($"Indirect draw: {problem}");
            return false;
        }

        mesh?.Device.Upload();
        return mesh is null || mesh.Device.IndexBuffer is not null;
    }

    public override void Record(CommandRecorder recorder, GpuRenderPipeline pipeline, ResourceBindings bindings, int copies)
    {
        if (mesh is not null)
        {
            recorder.SetIndexBuffer(mesh.Device.IndexBuffer!.Gpu, 0, mesh.Device.Indices32);
        }
        else if (indexBuffer is not null)
        {
            recorder.SetIndexBuffer(indexBuffer.Gpu, 0, indexBuffer.Stride == 4);
        }

        for (int i = 0; i < commands; i++)
        {
            if (Indexed)
            {
                recorder.DrawIndexedIndirect(pipeline, bindings, arguments.Gpu, offset + (i * (long)IndexedSize));
            }
            else
            {
                recorder.DrawIndirect(pipeline, bindings, arguments.Gpu, offset + (i * (long)PlainSize));
            }
        }
    }
}
