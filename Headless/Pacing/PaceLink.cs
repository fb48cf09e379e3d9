using System.Globalization;
using System.Net.Sockets;
using System.Text;

namespace Headless.Pacing;

/// <summary>
/// The line to the program that paces. A line each: "gpu FRAME MILLISECONDS TIMES NAME" for the finished scopes of a frame,
/// "count FRAME NUMBER NAME" for a counter, "ready FRAME SECONDS" before a frame; the answer to the last is "go FRAMES draw" or
/// "go FRAMES blind".
/// </summary>
internal sealed class PaceLink : IDisposable
{
    private readonly StreamReader reader;
    private readonly StreamWriter writer;

    public PaceLink(string path)
    {
        var socket = new Socket(AddressFamily.Unix, SocketType.Stream, ProtocolType.Unspecified);
        socket.Connect(new UnixDomainSocketEndPoint(path));
        var stream = new NetworkStream(socket, ownsSocket: true);
        (reader, writer) = (new StreamReader(stream), new StreamWriter(stream, new UTF8Encoding(false)));
    }

    public void Gpu(int frame, double milliseconds, int times, string name) => Write($"gpu {frame} {milliseconds:R} {times} {name}");

    public void Count(int frame, long number, string name) => Write($"count {frame} {number} {name}");

    /// <returns>How many frames to play before the next question, and whether cameras draw; null when the other end is gone.</returns>
    public (int Frames, bool Draws)? Ask(int frame, double seconds)
    {
        Write($"ready {frame} {seconds:R}");
        writer.Flush();
        return reader.ReadLine()?.Split(' ') is ["go", var frames, var what] ? (int.Parse(frames, CultureInfo.InvariantCulture), what == "draw") : null;
    }

    public void Dispose()
    {
        writer.Dispose();
        reader.Dispose();
    }

    private void Write(FormattableString line) => writer.Write(line.ToString(CultureInfo.InvariantCulture) + "\n");
}
