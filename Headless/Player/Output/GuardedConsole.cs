using System.Text;

namespace Headless.Player.Output;

/// <summary>
/// Standard output and error that may be full or closed: what cannot be shown is lost, and the run goes on, as its results are files. Where it was
/// standard output, the exit code says so.
/// </summary>
internal static class GuardedConsole
{
    private const int Failed = 1;
    private static GuardedWriter? output;

    public static void Begin()
    {
        Console.SetOut(output = new GuardedWriter(Console.Out));
        Console.SetError(new GuardedWriter(Console.Error));
    }

    /// <returns>The exit code.</returns>
    public static int End(int code)
    {
        if (output?.Problem is not { } problem) return code;
        Console.Error.WriteLine(Message.Of($"standard output cannot be written, so lines are missing: {problem}"));
        return code == 0 ? Failed : code;
    }

    private sealed class GuardedWriter(TextWriter inner) : TextWriter
    {
        /// <summary>Why something was lost first; null where nothing was.</summary>
        public string? Problem { get; private set; }

        public override Encoding Encoding => inner.Encoding;

        public override void Write(char value) => Try(() => inner.Write(value));

        public override void Write(char[] buffer, int index, int count) => Try(() => inner.Write(buffer, index, count));

        public override void Write(string? value) => Try(() => inner.Write(value));

        public override void WriteLine(string? value) => Try(() => inner.WriteLine(value));

        public override void Flush() => Try(inner.Flush);

        private void Try(Action write)
        {
            try
            {
                write();
            }
            catch (Exception e) when (e is IOException or UnauthorizedAccessException)
            {
                Problem ??= e.Message;
            }
        }
    }
}
