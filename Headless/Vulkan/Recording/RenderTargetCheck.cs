namespace Headless.Vulkan;

/// <summary>Checks render targets against each other and against pipelines.</summary>
internal static class RenderTargetCheck
{
    /// <summary>The common size in texels of all targets.</summary>
    public static (int Width, int Height) Size(RenderTargets targets)
    {
        (int Width, int Height)? size = null;
        string first = "";
        foreach ((GpuTexture texture, int mip, int slice) in All(targets))
        {
            CheckTarget(texture, mip, slice);
            (int width, int height, _) = texture.MipSize(mip);
            if (size is not null && size != (width, height))
            {
                throw new GpuException($"Target '{texture.Name}' is {width} x {height}, but '{first}' is {size.Value.Width} x {size.Value.Height}; targets have one size.");
            }

            size = (width, height);
            first = texture.Name;
        }

        return size ?? throw new GpuException("BeginRendering without a color or depth target.");
    }

    /// <summary>Throws unless the pipeline was made for these formats and samples.</summary>
    public static void Match(RenderTargets targets, GpuRenderPipeline pipeline)
    {
        RenderPipelineDescription requested = pipeline.Description;
        GpuFormat depth = targets.Depth?.Texture.Description.Format ?? GpuFormat.None;
        bool same = targets.Colors.Count == requested.ColorFormats.Count && depth == requested.DepthFormat;
        for (int i = 0; same && i < targets.Colors.Count; i++)
        {
            GpuTextureDescription color = targets.Colors[i].Texture.Description;
            same = color.Format == requested.ColorFormats[i] && color.Samples == requested.Samples;
        }

        same &= targets.Depth is null || targets.Depth.Texture.Description.Samples == requested.Samples;
        if (!same)
        {
            string formats = string.Join(", ", targets.Colors.Select(color => $"{color.Texture.Description.Format} x{color.Texture.Description.Samples}"));
            throw new GpuException(
                $"Shader '{pipeline.Name}' was made for ({string.Join(", ", requested.ColorFormats)}; {requested.DepthFormat}) with {requested.Samples} samples; " +
                $"the targets are ({formats}; {depth}).");
        }
    }

    private static IEnumerable<(GpuTexture Texture, int Mip, int Slice)> All(RenderTargets targets)
    {
        foreach (ColorTarget color in targets.Colors)
        {
            yield return (color.Texture, color.MipLevel, color.Slice);
            if (color.Resolve is not null)
            {
                yield return (color.Resolve, 0, 0);
            }
        }

        if (targets.Depth is not null)
        {
            yield return (targets.Depth.Texture, targets.Depth.MipLevel, targets.Depth.Slice);
        }
    }

    private static void CheckTarget(GpuTexture texture, int mip, int slice)
    {
        bool volume = texture.Description.Dimension == GpuTextureDimension.Texture3D;
        texture.CheckSubresource(mip, volume ? 0 : Math.Max(0, slice));
        if (!texture.Description.Usage.HasFlag(TextureUse.RenderTarget))
        {
            throw new GpuException($"Texture '{texture.Name}' was not created for use as a render target.");
        }

        if (volume && (slice < 0 || slice >= texture.MipSize(mip).Depth))
        {
            throw new GpuException($"Texture '{texture.Name}' has {texture.MipSize(mip).Depth} slices at level {mip}; slice {slice} is not in it.");
        }
    }
}
