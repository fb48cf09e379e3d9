using System;
using UnityEngine;

namespace Headless.Engine;

/// <summary>What a buffer was created for, and the view that follows from it: the reference of GraphicsBuffer.Target and ComputeBufferType.</summary>
/// <param name="Flags">The flags as the script gave them.</param>
/// <param name="Arguments">Whether indirect dispatches and draws may read it.</param>
internal readonly record struct BufferTargets(Enum? Flags, BufferView View, bool Arguments)
{
    /// <summary>Direct3D 11 refuses structured buffers with raw views: Structured wins.</summary>
    public static BufferTargets Of(GraphicsBuffer.Target target)
    {
        const GraphicsBuffer.Target structured =
            GraphicsBuffer.Target.Structured | GraphicsBuffer.Target.Append | GraphicsBuffer.Target.Counter;
        bool arguments = (target & GraphicsBuffer.Target.IndirectArguments) != 0;
        return new BufferTargets(target, ViewOf((target & structured) != 0, (target & GraphicsBuffer.Target.Raw) != 0, arguments), arguments);
    }

    /// <summary>Default is structured; with another flag a buffer is so only where Structured is named too, or a counter asks for it.</summary>
    public static BufferTargets Of(ComputeBufferType type)
    {
        const ComputeBufferType structured = ComputeBufferType.Structured | ComputeBufferType.Append | ComputeBufferType.Counter;
        bool arguments = (type & ComputeBufferType.IndirectArguments) != 0;
        bool isStructured = type == ComputeBufferType.Default || (type & structured) != 0;
        return new BufferTargets(type, ViewOf(isStructured, (type & ComputeBufferType.Raw) != 0, arguments), arguments);
    }

    private static BufferView ViewOf(bool structured, bool raw, bool arguments) =>
        structured ? BufferView.Structured : raw ? BufferView.Raw : arguments ? BufferView.Arguments : BufferView.None;
}
