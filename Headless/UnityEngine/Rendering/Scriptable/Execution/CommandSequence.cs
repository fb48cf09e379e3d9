namespace Headless.Engine;

/// <summary>Several commands as one.</summary>
internal sealed class CommandSequence(GpuCommand[] commands) : GpuCommand
{
    public override void Run(CommandContext context)
    {
        foreach (GpuCommand command in commands)
        {
            command.Run(context);
        }
    }
}
