using Headless.Vulkan.Native;

namespace Headless.Vulkan;

/// <summary>A command buffer with everything that must live until the device has run it.</summary>
internal sealed unsafe class Submission : IDisposable
{
    private readonly DeviceContext context;
    private readonly VkCommandPool pool;
    private readonly VkFence fence;
    private readonly List<Action> garbage = [];
    private readonly List<(ReadbackTicket Ticket, HostSlice Slice)> readbacks = [];

    public Submission(DeviceContext context, HostBlockPool uploads, HostBlockPool downloads)
    {
        this.context = context;
        Uploads = new HostArena(uploads);
        Downloads = new HostArena(downloads);
        Descriptors = new DescriptorArena(context);
        Timestamps = new TimestampLog(context);
        VkCommandPoolCreateInfo poolInfo = new() { flags = VkCommandPoolCreateFlags.Transient, queueFamilyIndex = context.QueueFamily };
        VkCommandPool createdPool;
        Vk.vkCreateCommandPool(context.Handle, &poolInfo, null, &createdPool).Check("Creating a command pool");
        pool = createdPool;
        VkCommandBufferAllocateInfo info = new() { commandPool = pool, level = VkCommandBufferLevel.Primary, commandBufferCount = 1 };
        VkCommandBuffer commands;
        Vk.vkAllocateCommandBuffers(context.Handle, &info, &commands).Check("Creating a command buffer");
        Commands = commands;
        VkFenceCreateInfo fenceInfo = new();
        VkFence createdFence;
        Vk.vkCreateFence(context.Handle, &fenceInfo, null, &createdFence).Check("Creating a fence");
        fence = createdFence;
    }

    public VkCommandBuffer Commands { get; }

    public HostArena Uploads { get; }

    public HostArena Downloads { get; }

    public DescriptorArena Descriptors { get; }

    public TimestampLog Timestamps { get; }

    /// <summary>Number of this submission; 0 before its first use.</summary>
    public ulong Ticket { get; private set; }

    public bool InFlight { get; private set; }

    public int CommandCount { get; set; }

    /// <summary>Threads of its dispatches, vertices and pixels of its draws.</summary>
    public long Work { get; set; }

    public bool HasReadbacks => readbacks.Count > 0;

    /// <summary>Nothing would happen if it were submitted.</summary>
    public bool IsEmpty => CommandCount == 0 && !HasReadbacks && Timestamps.Count == 0 && garbage.Count == 0;

    public void Begin(ulong ticket)
    {
        Ticket = ticket;
        CommandCount = 0;
        Work = 0;
        Vk.vkResetCommandPool(context.Handle, pool, 0).Check("Resetting a command pool");
        VkCommandBufferBeginInfo info = new() { flags = VkCommandBufferUsageFlags.OneTimeSubmit };
        Vk.vkBeginCommandBuffer(Commands, &info).Check("Beginning a command buffer");
        Timestamps.Reset(Commands);
    }

    public void Submit()
    {
        Vk.vkEndCommandBuffer(Commands).Check("Ending a command buffer");
        VkCommandBuffer commands = Commands;
        VkSubmitInfo info = new() { commandBufferCount = 1, pCommandBuffers = &commands };
        Vk.vkQueueSubmit(context.Queue, 1, &info, fence).Check("Submitting work");
        InFlight = true;
    }

    /// <summary>Runs once the device has finished with this submission.</summary>
    public void AddGarbage(Action release) => garbage.Add(release);

    public void AddReadback(ReadbackTicket ticket, HostSlice slice) => readbacks.Add((ticket, slice));

    /// <summary>Whether the device has run it; waits when asked to. Then hands out results and frees what was kept.</summary>
    public bool TryFinish(bool wait)
    {
        VkFence handle = fence;
        VkResult result = wait
            ? Vk.vkWaitForFences(context.Handle, 1, &handle, 1, ulong.MaxValue)
            : Vk.vkGetFenceStatus(context.Handle, handle);
        result.Check("Waiting for the device");
        if (result != VkResult.Success)
        {
            return false;
        }

        Vk.vkResetFences(context.Handle, 1, &handle).Check("Resetting a fence");
        InFlight = false;
        Timestamps.Read();
        foreach ((ReadbackTicket ticket, HostSlice slice) in readbacks)
        {
            ticket.Complete(slice.Bytes);
        }

        readbacks.Clear();
        Release();
        return true;
    }

    public void Dispose()
    {
        Release();
        Timestamps.Dispose();
        Descriptors.Dispose();
        Uploads.Dispose();
        Downloads.Dispose();
        Vk.vkDestroyFence(context.Handle, fence, null);
        Vk.vkDestroyCommandPool(context.Handle, pool, null);
    }

    private void Release()
    {
        garbage.ForEach(release => release());
        garbage.Clear();
        Uploads.Reset();
        Downloads.Reset();
        Descriptors.Reset();
    }
}
