using System.Linq;

namespace UnityEngine.Rendering.RenderGraphModule;

/// <summary>The recorded passes on their way into the context.</summary>
internal sealed class GraphRun(RenderGraph graph, in RenderGraphParameters parameters)
{
    public CommandBuffer Commands { get; } = parameters.commandBuffer;
    public ScriptableRenderContext Context { get; } = parameters.scriptableRenderContext;
    public RenderGraphDefaultResources DefaultResources => graph.defaultResources;

    public void Execute(GraphPass pass)
    {
        foreach (GraphTexture texture in pass.Read.Concat(pass.Written))
        {
            texture.Make();
        }

        Commands.BeginSample(pass.Name);
        ClearElsewhere(pass);
        SetTargets(pass);
        pass.Function?.Invoke(this);
        foreach ((GraphTexture texture, int id) in pass.GlobalsAfter)
        {
            texture.Make();
            Commands.SetGlobalTexture(id, texture.Handle!);
        }

        Commands.EndSample(pass.Name);
    }

    /// <summary>Hands what was recorded so far to the context.</summary>
    public void Submit()
    {
        Context.ExecuteCommandBuffer(Commands);
        Commands.Clear();
    }

    /// <summary>Sets the attachments of a raster pass, and clears those that are to be cleared on first use.</summary>
    public void SetTargets(GraphPass pass)
    {
        if (pass.Colors.Count == 0 && pass.Depth is null)
        {
            return;
        }

        GraphPass.Attachment[] colors = [.. pass.Colors.OrderBy(c => c.Index)];
        RenderTargetIdentifier depth = pass.Depth is { } d ? Identify(d) : colors.Length > 0 ? Identify(colors[0]) : default;
        switch (colors.Length)
        {
            case 0:
                Commands.SetRenderTarget(depth);
                break;
            case 1 when pass.Depth is null:
                Commands.SetRenderTarget(Identify(colors[0]));
                break;
            case 1:
                Commands.SetRenderTarget(Identify(colors[0]), depth);
                break;
            default:
                Commands.SetRenderTarget([.. colors.Select(Identify)], depth);
                break;
        }

        bool clearColor = colors.Any(c => Clears(c.Texture));
        bool clearDepth = pass.Depth is { } target && Clears(target.Texture);
        if (clearColor || clearDepth)
        {
            Color color = colors.Length > 0 ? colors[0].Texture.Description.clearColor : default;
            Commands.ClearRenderTarget(clearDepth, clearColor, color);
        }

        foreach (GraphTexture texture in pass.Written)
        {
            texture.IsTouched = true;
        }
    }

    /// <summary>What a pass is the first to use otherwise than as an attachment is cleared before it.</summary>
    private void ClearElsewhere(GraphPass pass)
    {
        foreach (GraphTexture texture in pass.Read.Concat(pass.Written).Distinct().Where(Clears))
        {
            if (!pass.Colors.Exists(c => c.Texture == texture) && pass.Depth?.Texture != texture)
            {
                Commands.SetRenderTarget(texture.Handle!);
                Commands.ClearRenderTarget(texture.Description.IsDepth, !texture.Description.IsDepth, texture.Description.clearColor);
                texture.IsTouched = true;
            }
        }
    }

    private static bool Clears(GraphTexture texture) => texture is { IsTouched: false, Description.clearBuffer: true };

    private static RenderTargetIdentifier Identify(GraphPass.Attachment attachment) => attachment is { Mip: 0, Slice: -1 }
        ? attachment.Texture.Handle!.nameID
        : new RenderTargetIdentifier(attachment.Texture.Handle!.nameID, attachment.Mip, CubemapFace.Unknown, attachment.Slice);
}
