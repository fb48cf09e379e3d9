namespace Headless.Engine;

/// <summary>A buffer set by name; Size 0 means the whole buffer.</summary>
internal readonly record struct BufferSlot(DeviceBuffer? Buffer, int Offset = 0, int Size = 0)
{
    public bool IsSet => Buffer is { IsValid: true };
}
