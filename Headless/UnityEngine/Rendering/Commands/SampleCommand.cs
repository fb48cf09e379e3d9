namespace Headless.Engine;

/// <summary>Opens or closes a GPU timer.</summary>
internal sealed class SampleCommand(string name, bool begin) : GpuCommand
{
    public override void Run(CommandContext context)
    {
        if (begin)
        {
            context.BeginSample(name);
        }
        else
        {
            context.EndSample(name);
        }
    }
}
