using Headless.Engine;
using UnityEngine.Rendering;

namespace UnityEngine;

public sealed partial class Light
{
    private readonly EventBuffers<LightEvent> commandBuffers = new();

    public int commandBufferCount => commandBuffers.Count;

    public void AddCommandBuffer(LightEvent evt, CommandBuffer buffer) => commandBuffers.Add(evt, buffer);

    public void RemoveCommandBuffer(LightEvent evt, CommandBuffer buffer) => commandBuffers.Remove(evt, buffer);

    public void RemoveCommandBuffers(LightEvent evt) => commandBuffers.Remove(evt);

    public void RemoveAllCommandBuffers() => commandBuffers.Clear();

    public CommandBuffer[] GetCommandBuffers(LightEvent evt) => commandBuffers.Of(evt);
}
