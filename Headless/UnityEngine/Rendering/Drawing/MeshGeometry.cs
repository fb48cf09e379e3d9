using Headless.Vulkan;
using UnityEngine.Rendering;
using UnityEngine;

namespace Headless.Engine;

/// <summary>A sub-mesh, once or in instances.</summary>
internal sealed class MeshGeometry(Mesh mesh, int subMesh, int instances) : DrawGeometry
{
    public override Mesh Mesh => mesh;
    public override MeshTopology Topology => mesh.SubMeshes[subMesh].topology;

    public override bool Prepare()
    {
        if (mesh == null || subMesh >= mesh.SubMeshes.Count)
        {
            return false;
        }

        mesh.Device.Upload();
        return mesh.Device.IndexBuffer is not null && mesh.Device.Range(subMesh).Count > 0;
    }

    public override void Record(CommandRecorder recorder, GpuRenderPipeline pipeline, ResourceBindings bindings, int copies)
    {
        (int start, int count) = mesh.Device.Range(subMesh);
        recorder.SetIndexBuffer(mesh.Device.IndexBuffer!.Gpu, 0, mesh.Device.Indices32);
        recorder.DrawIndexed(pipeline, bindings, (uint)count, (uint)(instances * copies), (uint)start, mesh.SubMeshes[subMesh].baseVertex);
    }
}
