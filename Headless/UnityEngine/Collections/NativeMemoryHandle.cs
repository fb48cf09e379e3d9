namespace Unity.Collections;

/// <summary>Shared by all copies of a native container, so that each notices Dispose.</summary>
class NativeMemoryHandle
{
    public bool IsReleased { get; private set; }

    public void Release() => IsReleased = true;
}
