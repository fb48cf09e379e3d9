namespace Headless.Vulkan;

/// <summary>Three submissions in turn: the device runs two while the third is recorded.</summary>
internal sealed class SubmissionRing : IDisposable
{
    private const int Length = 3;

    private readonly DeviceContext context;
    private readonly HostBlockPool uploads;
    private readonly HostBlockPool downloads;
    private readonly Submission[] submissions = new Submission[Length];
    private ulong oldest = 1;

    public SubmissionRing(DeviceContext context)
    {
        this.context = context;
        uploads = new HostBlockPool(context, readback: false);
        downloads = new HostBlockPool(context, readback: true);
        for (int i = 0; i < Length; i++)
        {
            submissions[i] = new Submission(context, uploads, downloads);
        }

        context.Memory.Reclaim = () => Wait(CurrentTicket);
        Current.Begin(CurrentTicket);
    }

    /// <summary>The submission being recorded.</summary>
    public Submission Current => At(CurrentTicket);

    public ulong CurrentTicket { get; private set; } = 1;

    /// <summary>Last ticket whose work has run.</summary>
    public ulong Completed => oldest - 1;

    /// <summary>Closes and submits what is recorded; set by the stream, which knows how to close it.</summary>
    public Action SubmitCurrent { get; set; } = static () => { };

    /// <summary>Submits the current command buffer and begins the next, waiting for its turn in the ring.</summary>
    public ulong Advance()
    {
        Current.Submit();
        ulong ticket = CurrentTicket++;
        Submission next = Current;
        while (next.InFlight)
        {
            FinishOldest(wait: true);
        }

        next.Begin(CurrentTicket);
        Poll();
        return ticket;
    }

    /// <summary>Waits for a ticket, submitting it first when it is still being recorded.</summary>
    public void Wait(ulong ticket)
    {
        if (ticket > CurrentTicket)
        {
            throw new ArgumentOutOfRangeException(nameof(ticket), $"Ticket {ticket} was never given out.");
        }

        if (ticket == CurrentTicket)
        {
            SubmitCurrent();
        }

        while (Completed < ticket)
        {
            FinishOldest(wait: true);
        }
    }

    /// <summary>Takes in what has finished.</summary>
    public void Poll(bool wait = false)
    {
        while (oldest < CurrentTicket && FinishOldest(wait))
        {
        }
    }

    /// <summary>Frees something once all work recorded so far has run.</summary>
    public void ReleaseLater(Action release) => Current.AddGarbage(release);

    public void Dispose()
    {
        Finish();
        foreach (Submission submission in submissions)
        {
            submission.Dispose();
        }

        uploads.Dispose();
        downloads.Dispose();
        context.Memory.Reclaim = null;
    }

    /// <summary>A lost device has nothing to wait for, and its first error is the one to report.</summary>
    private void Finish()
    {
        try
        {
            if (!Current.IsEmpty)
            {
                SubmitCurrent();
            }

            Poll(wait: true);
        }
        catch (GpuException)
        {
        }
    }

    private Submission At(ulong ticket) => submissions[ticket % Length];

    private bool FinishOldest(bool wait)
    {
        if (!At(oldest).TryFinish(wait))
        {
            return false;
        }

        oldest++;
        return true;
    }
}
