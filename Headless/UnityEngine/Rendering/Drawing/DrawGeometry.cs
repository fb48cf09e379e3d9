using Headless.Vulkan;
using UnityEngine;

namespace Headless.Engine;

/// <summary>The vertices of a draw and how they are handed to the device.</summary>
internal abstract class DrawGeometry
{
    public abstract MeshTopology Topology { get; }

    /// <summary>The mesh whose vertex streams are bound; null when the shader fetches vertices by number.</summary>
    public virtual Mesh? Mesh => null;

    /// <summary>Makes and uploads what the draw needs; before drawing begins. False when there is nothing to draw.</summary>
    public virtual bool Prepare() => true;

    /// <param name="copies">Of each instance; those that a buffer counts have one.</param>
    public abstract void Record(CommandRecorder recorder, GpuRenderPipeline pipeline, ResourceBindings bindings, int copies);

    public static GpuTopology Convert(MeshTopology topology) => topology switch
    {
        MeshTopology.Lines => GpuTopology.Lines,
        MeshTopology.LineStrip => GpuTopology.LineStrip,
        MeshTopology.Points => GpuTopology.Points,
        _ => GpuTopology.Triangles,
    };
}
