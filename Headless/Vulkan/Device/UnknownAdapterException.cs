namespace Headless.Vulkan;

/// <summary>No device has the name or index that was asked for; the message lists those there are.</summary>
public sealed class UnknownAdapterException(string message) : GpuException(message);
