using System.Collections.Generic;
using System;
using Headless.Engine;
using Unity.Profiling;
using UnityEngine.Profiling;

namespace UnityEngine.Rendering;

public partial class CommandBuffer : IDisposable
{
    private readonly List<GpuCommand> commands = [];
    private bool disposed;

    public string name { get; set; } = string.Empty;
    public int sizeInBytes => commands.Count * 64;

    public void Clear() => commands.Clear();

    public void Release() => Dispose();

    public void Dispose()
    {
        commands.Clear();
        disposed = true;
        GC.SuppressFinalize(this);
    }

    public void SetExecutionFlags(CommandBufferExecutionFlags flags)
    {
        if (commands.Count > 0)
        {
            throw new InvalidOperationException($"CommandBuffer '{name}': SetExecutionFlags must be called before any command is recorded.");
        }
    }

    public void BeginSample(string name) => Add(new SampleCommand(name, true));

    public void BeginSample(ProfilerMarker marker) => Add(new SampleCommand(marker.Name ?? "Unnamed", true));

    public void BeginSample(CustomSampler sampler) => Add(new SampleCommand(sampler.name, true));

    public void EndSample(string name) => Add(new SampleCommand(name, false));

    public void EndSample(ProfilerMarker marker) => Add(new SampleCommand(marker.Name ?? "Unnamed", false));

    public void EndSample(CustomSampler sampler) => Add(new SampleCommand(sampler.name, false));

    /// <summary>Runs the commands in order; the buffer can be run again.</summary>
    internal void Execute(DrawTarget? cameraTarget)
    {
        using var temporaries = new NamedTemporaries();
        Execute(cameraTarget, temporaries);
    }

    internal void Execute(DrawTarget? cameraTarget, NamedTemporaries temporaries)
    {
        var context = new CommandContext(cameraTarget, temporaries);
        try
        {
            foreach (GpuCommand command in commands)
            {
                command.Run(context);
            }
        }
        finally
        {
            context.Finish();
        }
    }

    private void Add(GpuCommand command)
    {
        ObjectDisposedException.ThrowIf(disposed, this);
        commands.Add(command);
    }

    private void Add(Action<CommandContext> action) => Add(new ActionCommand(action));
}
