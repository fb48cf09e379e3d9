using System;
using System.Collections.Generic;

namespace Headless.Engine;

/// <summary>What a pipeline has recorded in one call, and what goes on from one submission to the next.</summary>
internal sealed class ContextCommands : IDisposable
{
    private readonly List<GpuCommand> waiting = [];
    private readonly NamedTemporaries temporaries = new();
    private readonly CommandContext context;

    public ContextCommands() => context = new CommandContext(null, temporaries);

    public bool IsOver { get; private set; }

    public void Add(GpuCommand command) => waiting.Add(command);

    public void Submit()
    {
        GpuCommand[] now = [.. waiting];
        waiting.Clear();
        foreach (GpuCommand command in now)
        {
            command.Run(context);
        }

        TargetState.Finish();
    }

    /// <summary>What was not submitted is dropped.</summary>
    public void Dispose()
    {
        IsOver = true;
        context.Finish();
        temporaries.Dispose();
    }
}
