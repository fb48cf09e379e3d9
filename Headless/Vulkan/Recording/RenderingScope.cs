using Headless.Vulkan.Native;

namespace Headless.Vulkan;

/// <summary>The open targets and whether Vulkan's rendering instance is running on them.</summary>
internal sealed unsafe class RenderingScope(CommandStream stream)
{
    private RenderTargets? targets;
    private bool running;
    private bool loaded;

    /// <summary>Texels along x of the targets.</summary>
    public int Width { get; private set; }

    /// <summary>Texels along y of the targets.</summary>
    public int Height { get; private set; }

    public void Open(RenderTargets opened)
    {
        if (targets is not null)
        {
            throw new InvalidOperationException("BeginRendering inside BeginRendering: call EndRendering first.");
        }

        (Width, Height) = RenderTargetCheck.Size(opened);
        targets = opened;
        loaded = false;
    }

    /// <summary>Ends the run of draws; targets that nobody drew to are still cleared.</summary>
    public void Close()
    {
        if (targets is null)
        {
            throw new InvalidOperationException("EndRendering without BeginRendering.");
        }

        bool clears = targets.Colors.Any(color => color.Load == TargetLoad.Clear || color.Resolve is not null) || targets.Depth?.Load == TargetLoad.Clear;
        if (!loaded && clears)
        {
            stream.Begin(insideRendering: true);
            Enter();
            stream.Count();
        }

        Pause();
        targets = null;
    }

    /// <summary>Throws unless targets are open that the pipeline was made for.</summary>
    public void Check(GpuRenderPipeline pipeline)
    {
        if (targets is null)
        {
            throw new InvalidOperationException($"Draw of '{pipeline.Name}' outside BeginRendering and EndRendering.");
        }

        RenderTargetCheck.Match(targets, pipeline);
    }

    /// <summary>Records the barrier of the coming draw and makes the rendering instance run.</summary>
    public void Enter()
    {
        if (running && stream.Hazards.NeedsBarrier)
        {
            Pause();
        }

        if (running)
        {
            stream.Hazards.Commit(stream.Commands);
            return;
        }

        UseTargets();
        stream.Hazards.Commit(stream.Commands);
        BeginNative();
        running = true;
        loaded = true;
    }

    /// <summary>Ends the rendering instance for now; the next draw goes on with the content kept.</summary>
    public void Pause()
    {
        if (running)
        {
            Vk.vkCmdEndRendering(stream.Commands);
            running = false;
        }
    }

    private static VkImageView View(GpuTexture texture, int mip, int slice) => slice < 0
        ? texture.Views.Get(VkImageViewType._2dArray, mip, 1, 0, texture.Description.Layers)
        : texture.Views.Get(VkImageViewType._2d, mip, 1, slice, 1);

    private int Layers => (targets!.Colors.Count > 0 ? (targets.Colors[0].Texture, targets.Colors[0].Slice) : (targets.Depth!.Texture, targets.Depth.Slice))
        is (GpuTexture texture, < 0) ? texture.Description.Layers : 1;

    private void UseTargets()
    {
        HazardTracker hazards = stream.Hazards;
        foreach (ColorTarget color in targets!.Colors)
        {
            hazards.Use(color.Texture, VkImageLayout.ColorAttachmentOptimal, write: true, VkPipelineStageFlags2.ColorAttachmentOutput);
            if (color.Resolve is not null)
            {
                hazards.Use(color.Resolve, VkImageLayout.ColorAttachmentOptimal, write: true, VkPipelineStageFlags2.ColorAttachmentOutput);
            }
        }

        if (targets.Depth is not null)
        {
            const VkPipelineStageFlags2 Tests = VkPipelineStageFlags2.EarlyFragmentTests | VkPipelineStageFlags2.LateFragmentTests;
            hazards.Use(targets.Depth.Texture, VkImageLayout.DepthStencilAttachmentOptimal, write: true, Tests);
        }
    }

    private void BeginNative()
    {
        int count = targets!.Colors.Count;
        VkRenderingAttachmentInfo* colors = stackalloc VkRenderingAttachmentInfo[count];
        for (int i = 0; i < count; i++)
        {
            colors[i] = Color(targets.Colors[i]);
        }

        VkRenderingAttachmentInfo depth = default;
        if (targets.Depth is not null)
        {
            depth = Depth(targets.Depth);
        }

        VkRenderingInfo info = new()
        {
            renderArea = new VkRect2D { extent = new VkExtent2D { width = (uint)Width, height = (uint)Height } },
            layerCount = (uint)Layers,
            colorAttachmentCount = (uint)count,
            pColorAttachments = colors,
            pDepthAttachment = targets.Depth is null ? null : &depth,
        };
        Vk.vkCmdBeginRendering(stream.Commands, &info);
    }

    private VkRenderingAttachmentInfo Color(ColorTarget target)
    {
        VkRenderingAttachmentInfo info = new()
        {
            imageView = View(target.Texture, target.MipLevel, target.Slice),
            imageLayout = VkImageLayout.ColorAttachmentOptimal,
            loadOp = LoadOperation(target.Load),
            storeOp = VkAttachmentStoreOp.Store,
        };
        for (int i = 0; i < 4; i++)
        {
            if (target.Texture.Info.Integer)
            {
                info.clearValue.color.int32[i] = (int)target.Clear[i];
            }
            else
            {
                info.clearValue.color.float32[i] = target.Clear[i];
            }
        }

        if (target.Resolve is not null)
        {
            info.resolveMode = target.Texture.Info.Integer ? VkResolveModeFlags.SampleZero : VkResolveModeFlags.Average;
            info.resolveImageView = View(target.Resolve, 0, target.Slice);
            info.resolveImageLayout = VkImageLayout.ColorAttachmentOptimal;
        }

        return info;
    }

    private VkRenderingAttachmentInfo Depth(DepthTarget target)
    {
        VkRenderingAttachmentInfo info = new()
        {
            imageView = View(target.Texture, target.MipLevel, target.Slice),
            imageLayout = VkImageLayout.DepthStencilAttachmentOptimal,
            loadOp = LoadOperation(target.Load),
            storeOp = VkAttachmentStoreOp.Store,
        };
        info.clearValue.depthStencil.depth = target.Clear;
        return info;
    }

    private VkAttachmentLoadOp LoadOperation(TargetLoad load) => (loaded ? TargetLoad.Load : load) switch
    {
        TargetLoad.Clear => VkAttachmentLoadOp.Clear,
        TargetLoad.Discard => VkAttachmentLoadOp.DontCare,
        _ => VkAttachmentLoadOp.Load,
    };
}
