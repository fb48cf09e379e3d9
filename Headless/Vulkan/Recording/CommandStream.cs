using Headless.Vulkan.Native;

namespace Headless.Vulkan;

/// <summary>The command buffer being recorded, and what every kind of command needs: hazards, bindings, submission.</summary>
internal sealed unsafe class CommandStream
{
    private const int CommandLimit = 4000;

    // Threads, vertices and pixels of a submission: half a second where each takes 5 ns, as on a slow card the threads of a liquid's step
    // do. Windows takes a submission of two seconds for a hang and resets the device.
    private const long WorkLimit = 100_000_000;
    private const long UploadLimit = 128 << 20;

    /// <summary>Work of a dispatch or draw whose size is in a buffer of the device.</summary>
    public const long UnknownWork = 1_000_000;

    public CommandStream(DeviceContext context, SubmissionRing ring, PipelineLibrary pipelines)
    {
        Context = context;
        Ring = ring;
        Pipelines = pipelines;
        Binder = new PipelineBinder(context);
        ring.SubmitCurrent = () => SubmitNow();
    }

    public DeviceContext Context { get; }

    public SubmissionRing Ring { get; }

    public PipelineLibrary Pipelines { get; }

    public HazardTracker Hazards { get; } = new();

    public PipelineBinder Binder { get; }

    public Submission Current => Ring.Current;

    public VkCommandBuffer Commands => Ring.Current.Commands;

    public long CommandCount { get; private set; }

    /// <summary>Dispatches and draws among them.</summary>
    public long WorkCount { get; private set; }

    /// <summary>Closes an open rendering instance; set by the draw commands.</summary>
    public Action LeaveRendering { get; set; } = static () => { };

    /// <summary>Timestamps of open scopes at the end of a submission; set by the timer commands.</summary>
    public Action PauseTimers { get; set; } = static () => { };

    /// <summary>Their timestamps before the first command of the next; set by the timer commands.</summary>
    public Action ResumeTimers { get; set; } = static () => { };

    /// <summary>First call of every command; a full command buffer is submitted before it, by its commands, what they upload or their work.</summary>
    public void Begin(bool insideRendering = false)
    {
        Submission current = Current;
        if (current.CommandCount >= CommandLimit || current.Work >= WorkLimit || current.Uploads.Used + current.Downloads.Used > UploadLimit)
        {
            SubmitNow();
        }

        ResumeTimers();
        if (!insideRendering)
        {
            LeaveRendering();
        }

        Hazards.Forget();
    }

    /// <summary>Last call of every command.</summary>
    public void Count()
    {
        Current.CommandCount++;
        CommandCount++;
    }

    /// <summary>In place of <see cref="Count"/> after a dispatch or a draw.</summary>
    /// <param name="work">Threads, or vertices and pixels.</param>
    public void CountWork(long work)
    {
        Current.Work += work;
        WorkCount++;
        Count();
    }

    /// <summary>Submits what is recorded; nothing recorded gives the last ticket again.</summary>
    public ulong Submit() => Current.IsEmpty ? Ring.CurrentTicket - 1 : SubmitNow();

    private ulong SubmitNow()
    {
        LeaveRendering();
        PauseTimers();
        if (Current.HasReadbacks)
        {
            ShowToHost();
        }

        Binder.Forget();
        return Ring.Advance();
    }

    private void ShowToHost()
    {
        VkMemoryBarrier2 memory = new()
        {
            srcStageMask = VkPipelineStageFlags2.AllTransfer,
            srcAccessMask = VkAccessFlags2.TransferWrite,
            dstStageMask = VkPipelineStageFlags2.Host,
            dstAccessMask = VkAccessFlags2.HostRead,
        };
        VkDependencyInfo info = new() { memoryBarrierCount = 1, pMemoryBarriers = &memory };
        Vk.vkCmdPipelineBarrier2(Commands, &info);
    }
}
