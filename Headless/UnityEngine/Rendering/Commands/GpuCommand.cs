namespace Headless.Engine;

/// <summary>A recorded command with the values it was recorded with.</summary>
internal abstract class GpuCommand
{
    public abstract void Run(CommandContext context);
}
