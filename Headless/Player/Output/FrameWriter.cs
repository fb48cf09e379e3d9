using System.Globalization;
using System.Threading.Channels;

namespace Headless.Player.Output;

/// <summary>Encodes frames to <c>frame_00000.png</c>… off the main thread. A short queue bounds the memory: a frame waits when the disk is slower than the drawing.</summary>
public sealed class FrameWriter : IDisposable
{
    private readonly record struct Frame(int Number, int Width, int Height, byte[] Rgba);

    private readonly Channel<Frame> queue = Channel.CreateBounded<Frame>(4);
    private readonly string folder;
    private readonly Film? film;
    private readonly Task worker;
    private readonly Action<string>? first;
    private volatile int written;

    /// <param name="folder">Folder of the frames.</param>
    /// <param name="film">Gets each frame when its file is there; null for no film.</param>
    /// <param name="first">Called with the path of the first file when it is there, on another thread.</param>
    public FrameWriter(string folder, Film? film = null, Action<string>? first = null)
    {
        this.first = first;
        this.folder = folder;
        this.film = film;
        worker = Task.Run(Work);
    }

    public int Written => written;

    public static string Name(int number) => string.Create(CultureInfo.InvariantCulture, $"frame_{number:D5}.png");

    /// <param name="rgba">Top row first; belongs to the writer from here on.</param>
    public void Add(int number, int width, int height, byte[] rgba)
    {
        if (worker.IsFaulted) worker.GetAwaiter().GetResult();
        ValueTask added = queue.Writer.WriteAsync(new Frame(number, width, height, rgba));
        if (!added.IsCompletedSuccessfully) added.AsTask().GetAwaiter().GetResult();
    }

    /// <summary>Takes no more frames and waits for those that there are; for the thread that ends an interrupted run.</summary>
    /// <returns>Whether the last one is done.</returns>
    public bool Stop(TimeSpan patience)
    {
        queue.Writer.TryComplete();
        return Task.WhenAny(worker, Task.Delay(patience)).Result == worker;
    }

    /// <summary>Waits until every frame is on the disk.</summary>
    public void Finish()
    {
        queue.Writer.TryComplete();
        worker.GetAwaiter().GetResult();
    }

    public void Dispose()
    {
        queue.Writer.TryComplete();
        try
        {
            worker.Wait();
        }
        catch (AggregateException)
        {
            // Finish reports it; a failed run must not hide its first error behind this one.
        }
    }

    private async Task Work()
    {
        try
        {
            await foreach (Frame frame in queue.Reader.ReadAllAsync().ConfigureAwait(false))
            {
                string path = Path.Combine(folder, Name(frame.Number));
                WholeFile.Write(path, stream => Png.Write(stream, frame.Width, frame.Height, frame.Rgba));
                if (++written == 1) first?.Invoke(path);
                film?.Add(frame.Width, frame.Height, frame.Rgba);
            }
        }
        catch (Exception e)
        {
            queue.Writer.TryComplete(e);
            throw;
        }
    }
}
