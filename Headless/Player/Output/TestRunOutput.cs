using System.Text;
using Headless.Engine;
using UnityEngine;

namespace Headless.Player.Output;

/// <summary>
/// Passes the test runner's lines on, with the console's lines of a test only when it failed: tests of errors log them on
/// purpose. Counts the tests that ran a shader: buffers that are filled, as those of poisoned memory, or read are no use of the GPU.
/// </summary>
internal sealed class TestRunOutput(TextWriter target) : TextWriter
{
    private const string Passed = "  pass  ", Failed = "  FAIL  ";
    private readonly List<string> console = [];
    private long work;

    public int UsedGpu { get; private set; }

    public override Encoding Encoding => target.Encoding;

    public override void WriteLine(string? value)
    {
        bool failed = value?.StartsWith(Failed, StringComparison.Ordinal) == true;
        if (failed || value?.StartsWith(Passed, StringComparison.Ordinal) == true)
        {
            long now = GraphicsDevice.Recorder.WorkCount;
            if (now != work) UsedGpu++;
            work = now;
            if (failed)
                foreach (string line in console) target.WriteLine("        " + line);
            console.Clear();
        }
        target.WriteLine(value);
    }

    public void AddConsoleLine(LogType type, string line) => console.Add(line);

    public override void Write(char value) => target.Write(value);

    public override void Flush() => target.Flush();
}
