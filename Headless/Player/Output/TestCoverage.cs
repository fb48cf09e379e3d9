using System.Globalization;
using Headless.Engine;

namespace Headless.Player.Output;

/// <summary>
/// Writes a line a test: full name, status, seconds, the kernel variants it dispatched and the marks it set, with tabs
/// between them. Scripts set marks in the array of bytes that the application context holds under <see cref="MarksName"/>;
/// a script assembly can be compiled with a mark in each of its methods.
/// </summary>
internal sealed class TestCoverage : IDisposable
{
    public const string MarksName = "sphplayer.test.marks";
    private const int MarkCount = 1 << 16;
    private readonly byte[] marks = new byte[MarkCount];
    private readonly StreamWriter file;

    public TestCoverage(string path)
    {
        file = new StreamWriter(path) { NewLine = "\n", AutoFlush = true };
        AppContext.SetData(MarksName, marks);
        KernelUse.Begin();
    }

    public void Add(TestOutcome outcome)
    {
        IEnumerable<int> set = Enumerable.Range(0, MarkCount).Where(i => marks[i] != 0);
        file.WriteLine(string.Join('\t', outcome.FullName, outcome.Status, outcome.Seconds.ToString("0.000", CultureInfo.InvariantCulture),
            string.Join(';', KernelUse.Take()), string.Join(' ', set)));
        Array.Clear(marks);
    }

    public void Dispose()
    {
        file.Dispose();
        AppContext.SetData(MarksName, null);
    }
}
