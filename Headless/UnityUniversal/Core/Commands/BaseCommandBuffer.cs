using System;
using UnityEngine.Rendering.RenderGraphModule;

namespace UnityEngine.Rendering;

/// <summary>What passes of a render graph may record, over a command buffer.</summary>
public class BaseCommandBuffer
{
    internal BaseCommandBuffer(CommandBuffer wrapped) => Wrapped = wrapped;

    public string name => Wrapped.name;
    public int sizeInBytes => Wrapped.sizeInBytes;

    internal CommandBuffer Wrapped { get; }

    /// <summary>The pass that records now; null outside a render graph.</summary>
    internal GraphPass? Pass { get; set; }

    /// <summary>Of the render graph; null outside.</summary>
    internal GraphRun? Run { get; set; }

    /// <summary>The command buffer, for a pass that may change what later passes see.</summary>
    /// <exception cref="InvalidOperationException">The pass has not asked for it.</exception>
    internal CommandBuffer Global()
    {
        if (Pass is { AllowsGlobalState: false } pass)
        {
            throw new InvalidOperationException(
                $"{pass.Name}: Modifying global state from this command buffer is not allowed. Please ensure your render graph pass allows modifying global state.");
        }

        return Wrapped;
    }

    /// <exception cref="InvalidOperationException">The pass has not declared the texture.</exception>
    internal TextureHandle Read(in TextureHandle handle)
    {
        if (Pass is { } pass && !pass.Uses(handle))
        {
            throw new InvalidOperationException(
                $"Pass '{pass.Name}' is trying to use a texture on the command buffer that was never registered with the pass builder. Please indicate the texture use to the pass builder.");
        }

        return handle;
    }

    /// <summary>What only the context can do, in the order of the commands; the pass's targets are set again afterwards.</summary>
    internal void Between(Action<ScriptableRenderContext> action)
    {
        Global();
        if (Run is not { } run)
        {
            throw new InvalidOperationException("Only passes of a render graph may do this.");
        }

        run.Submit();
        action(run.Context);
        run.SetTargets(Pass!);
    }
}
