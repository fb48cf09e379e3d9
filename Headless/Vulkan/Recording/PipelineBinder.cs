using Headless.Vulkan.Native;

namespace Headless.Vulkan;

/// <summary>Binds a pipeline and its descriptor sets, leaving out what is bound already.</summary>
internal sealed unsafe class PipelineBinder(DeviceContext context)
{
    private readonly DescriptorContent content = new(context);
    private readonly BoundState compute = new();
    private readonly BoundState graphics = new();
    private readonly SetState[] next = [new(), new(), new()];

    /// <summary>Finds the descriptor sets and tells the hazards what the command reads and writes.</summary>
    public void Gather(GpuPipeline pipeline, ResourceBindings bindings, Submission submission, HazardTracker hazards)
    {
        for (int set = 0; set < pipeline.Stages.Length; set++)
        {
            StageLayout layout = pipeline.Stages[set];
            if (layout.Entries.Length == 0)
            {
                continue;
            }

            ReadOnlySpan<ulong> words = content.Gather(pipeline, set, bindings, submission, hazards);
            next[set].Assign(submission.Descriptors.Get(layout, words), content.DynamicOffsets);
        }
    }

    /// <summary>Records the binding of what <see cref="Gather"/> found.</summary>
    public void Bind(VkCommandBuffer commands, GpuPipeline pipeline)
    {
        BoundState bound = pipeline.BindPoint == VkPipelineBindPoint.Compute ? compute : graphics;
        if (bound.Pipeline != pipeline.Handle)
        {
            Vk.vkCmdBindPipeline(commands, pipeline.BindPoint, pipeline.Handle);
            bound.Pipeline = pipeline.Handle;
            foreach (SetState set in bound.Sets)
            {
                set.Forget();
            }
        }

        for (int set = 0; set < pipeline.Stages.Length; set++)
        {
            SetState requested = next[set];
            if (pipeline.Stages[set].Entries.Length == 0 || bound.Sets[set].Same(requested))
            {
                continue;
            }

            bound.Sets[set].Assign(requested.Set, requested.Offsets);
            VkDescriptorSet handle = requested.Set;
            fixed (uint* offsets = requested.Offsets)
            {
                Vk.vkCmdBindDescriptorSets(
                    commands, pipeline.BindPoint, pipeline.Layout, (uint)set, 1, &handle, (uint)requested.Offsets.Length, offsets);
            }
        }
    }

    /// <summary>A new command buffer has nothing bound.</summary>
    public void Forget()
    {
        compute.Forget();
        graphics.Forget();
    }

    private sealed class BoundState
    {
        public VkPipeline Pipeline { get; set; }

        public SetState[] Sets { get; } = [new(), new(), new()];

        public void Forget()
        {
            Pipeline = default;
            foreach (SetState set in Sets)
            {
                set.Forget();
            }
        }
    }

    private sealed class SetState
    {
        private uint[] offsets = new uint[16];
        private int count;

        public VkDescriptorSet Set { get; private set; }

        public ReadOnlySpan<uint> Offsets => offsets.AsSpan(0, count);

        public void Assign(VkDescriptorSet set, ReadOnlySpan<uint> dynamicOffsets)
        {
            if (dynamicOffsets.Length > offsets.Length)
            {
                offsets = new uint[dynamicOffsets.Length];
            }

            Set = set;
            count = dynamicOffsets.Length;
            dynamicOffsets.CopyTo(offsets);
        }

        public bool Same(SetState other) => Set == other.Set && Offsets.SequenceEqual(other.Offsets);

        public void Forget() => Set = default;
    }
}
