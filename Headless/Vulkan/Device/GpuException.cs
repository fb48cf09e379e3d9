namespace Headless.Vulkan;

/// <summary>A request that the device or this layer cannot carry out; the message names the object, the limit and the cure.</summary>
public class GpuException : Exception
{
    /// <summary>Creates the error with a message that a user can act on.</summary>
    public GpuException(string message, Exception? inner = null) : base(message, inner)
    {
    }
}
