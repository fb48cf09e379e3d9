using System;

namespace Headless.Engine;

/// <summary>A command that is rare enough to be a closure.</summary>
internal sealed class ActionCommand(Action<CommandContext> action) : GpuCommand
{
    public override void Run(CommandContext context) => action(context);
}
