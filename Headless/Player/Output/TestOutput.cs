using System.Text;
using Headless.Engine;

namespace Headless.Player.Output;

/// <summary>Passes the test runner's lines on and counts the tests during which commands for the device were recorded.</summary>
internal sealed class TestOutput(TextWriter target) : TextWriter
{
    private static readonly string[] Verdicts = ["  pass  ", "  FAIL  "];
    private long commands = GraphicsDevice.Recorder.CommandCount;

    public int UsedGpu { get; private set; }

    public override Encoding Encoding => target.Encoding;

    public override void WriteLine(string? value)
    {
        if (value is not null && Array.Exists(Verdicts, v => value.StartsWith(v, StringComparison.Ordinal)))
        {
            long now = GraphicsDevice.Recorder.CommandCount;
            if (now != commands) UsedGpu++;
            commands = now;
        }
        target.WriteLine(value);
    }

    public override void Write(char value) => target.Write(value);

    public override void Flush() => target.Flush();
}
