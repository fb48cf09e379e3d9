namespace Headless.Vulkan;

/// <summary>A buffer or texture of a device: its name and, for hazards, when commands last read and wrote it.</summary>
public abstract class GpuResource : IDisposable
{
    private protected GpuResource(string name) => Name = name;

    /// <summary>Name in errors and captures.</summary>
    public string Name { get; }

    /// <summary>Whether it was disposed.</summary>
    public bool IsDisposed { get; private set; }

    internal ulong LastRead { get; set; }

    internal ulong LastWrite { get; set; }

    /// <summary>Frees the memory once the device has finished with it.</summary>
    public void Dispose()
    {
        if (!IsDisposed)
        {
            IsDisposed = true;
            Release();
        }
    }

    internal void ThrowIfDisposed()
    {
        if (IsDisposed)
        {
            throw new ObjectDisposedException(Name, $"'{Name}' was disposed before this use.");
        }
    }

    private protected abstract void Release();
}
