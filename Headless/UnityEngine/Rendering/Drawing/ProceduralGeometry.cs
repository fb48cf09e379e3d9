using System;
using Headless.Vulkan;
using UnityEngine;

namespace Headless.Engine;

/// <summary>Vertices without streams, numbered by SV_VertexID, with or without an index buffer.</summary>
internal sealed class ProceduralGeometry(
    MeshTopology topology, int count, int instances, DeviceBuffer? indexBuffer = null, int startIndex = 0) : DrawGeometry
{
    private DeviceBuffer? quadIndices;

    public override MeshTopology Topology => topology;

    public override bool Prepare()
    {
        if (topology == MeshTopology.Quads)
        {
            if (indexBuffer is not null)
            {
                throw new NotSupportedException("Procedural quads with an index buffer can't be drawn on this device: use triangles.");
            }

            quadIndices = QuadIndices.For(count / 4);
        }

        return count > 0 && instances > 0 && indexBuffer is null or { IsValid: true };
    }

    public override void Record(CommandRecorder recorder, GpuRenderPipeline pipeline, ResourceBindings bindings, int copies)
    {
        if (quadIndices is not null)
        {
            recorder.SetIndexBuffer(quadIndices.Gpu, 0, true);
            recorder.DrawIndexed(pipeline, bindings, (uint)(count / 4 * 6), (uint)(instances * copies));
        }
        else if (indexBuffer is not null)
        {
            recorder.SetIndexBuffer(indexBuffer.Gpu, 0, indexBuffer.Stride == 4);
            recorder.DrawIndexed(pipeline, bindings, (uint)count, (uint)(instances * copies), (uint)startIndex);
        }
        else
        {
            recorder.Draw(pipeline, bindings, (uint)count, (uint)(instances * copies));
        }
    }
}
