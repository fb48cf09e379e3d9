using Headless.Engine;
using UnityEngine.Rendering;

namespace UnityEngine;

public sealed partial class Camera
{
    private readonly EventBuffers<CameraEvent> commandBuffers = new();

    public int commandBufferCount => commandBuffers.Count;

    public void AddCommandBuffer(CameraEvent evt, CommandBuffer buffer) => commandBuffers.Add(evt, buffer);

    public void RemoveCommandBuffer(CameraEvent evt, CommandBuffer buffer) => commandBuffers.Remove(evt, buffer);

    public void RemoveCommandBuffers(CameraEvent evt) => commandBuffers.Remove(evt);

    public void RemoveAllCommandBuffers() => commandBuffers.Clear();

    public CommandBuffer[] GetCommandBuffers(CameraEvent evt) => commandBuffers.Of(evt);
}
