using System.Collections.Generic;
using System.Linq;
using System;
using UnityEngine.Rendering;

namespace UnityEngine;

public sealed partial class Light
{
    private readonly List<(LightEvent Event, CommandBuffer Buffer)> commandBuffers = [];

    public int commandBufferCount => commandBuffers.Count;

    public void AddCommandBuffer(LightEvent evt, CommandBuffer buffer)
    {
        ArgumentNullException.ThrowIfNull(buffer);
        commandBuffers.Add((evt, buffer));
    }

    public void RemoveCommandBuffer(LightEvent evt, CommandBuffer buffer) =>
        commandBuffers.RemoveAll(c => c.Event == evt && ReferenceEquals(c.Buffer, buffer));

    public void RemoveCommandBuffers(LightEvent evt) => commandBuffers.RemoveAll(c => c.Event == evt);

    public void RemoveAllCommandBuffers() => commandBuffers.Clear();

    public CommandBuffer[] GetCommandBuffers(LightEvent evt) => [.. commandBuffers.Where(c => c.Event == evt).Select(c => c.Buffer)];
}
