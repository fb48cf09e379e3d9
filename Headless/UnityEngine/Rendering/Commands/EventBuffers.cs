using System.Collections.Generic;
using System.Linq;
using System;
using UnityEngine.Rendering;

namespace Headless.Engine;

/// <summary>Command buffers that scripts add to the events of a camera or a light, in the order in which they were added.</summary>
internal sealed class EventBuffers<TEvent>
    where TEvent : struct, Enum
{
    private readonly List<(TEvent Event, CommandBuffer Buffer)> buffers = [];

    public int Count => buffers.Count;

    public void Add(TEvent evt, CommandBuffer buffer)
    {
        ArgumentNullException.ThrowIfNull(buffer);
        buffers.Add((evt, buffer));
    }

    public void Remove(TEvent evt, CommandBuffer buffer) => buffers.RemoveAll(c => Is(c.Event, evt) && ReferenceEquals(c.Buffer, buffer));

    public void Remove(TEvent evt) => buffers.RemoveAll(c => Is(c.Event, evt));

    public void Clear() => buffers.Clear();

    public CommandBuffer[] Of(TEvent evt) => [.. buffers.Where(c => Is(c.Event, evt)).Select(c => c.Buffer)];

    private static bool Is(TEvent one, TEvent other) => EqualityComparer<TEvent>.Default.Equals(one, other);
}
