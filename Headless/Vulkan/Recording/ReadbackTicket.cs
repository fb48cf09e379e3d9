namespace Headless.Vulkan;

/// <summary>Bytes that are read back from the device; complete when the work recorded before the request has run.</summary>
public sealed class ReadbackTicket
{
    private readonly SubmissionRing ring;
    private byte[]? data;

    internal ReadbackTicket(SubmissionRing ring, ulong submission, int size)
    {
        this.ring = ring;
        Submission = submission;
        Size = size;
    }

    /// <summary>Bytes asked for.</summary>
    public int Size { get; }

    /// <summary>Whether <see cref="Data"/> can be read without waiting.</summary>
    public bool IsDone
    {
        get
        {
            if (data is null)
            {
                ring.Poll();
            }

            return data is not null;
        }
    }

    /// <summary>The bytes; textures have tightly packed rows, first row at the top.</summary>
    /// <exception cref="InvalidOperationException">The ticket is not done.</exception>
    public ReadOnlySpan<byte> Data =>
        IsDone ? data : throw new InvalidOperationException("The read-back is not done: test IsDone or call Wait first.");

    internal ulong Submission { get; }

    /// <summary>Submits what is recorded, if needed, and waits for the bytes.</summary>
    public ReadOnlySpan<byte> Wait()
    {
        if (data is null)
        {
            ring.Wait(Submission);
        }

        return Data;
    }

    internal void Complete(ReadOnlySpan<byte> bytes) => data = bytes.ToArray();
}
