using System.Globalization;
using System.Threading.Channels;

namespace Headless.Player.Output;

/// <summary>Encodes frames to <c>frame_00000.png</c>… off the main thread. A short queue bounds the memory: a frame waits when the disk is slower than the drawing.</summary>
public sealed class FrameWriter : IDisposable
{
    private readonly record struct Frame(int Number, int Width, int Height, byte[] Rgba);

    private readonly Channel<Frame> queue = Channel.CreateBounded<Frame>(4);
    private readonly string folder;
    private readonly Task worker;
    private int written;

    public FrameWriter(string folder)
    {
        this.folder = folder;
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
                string partial = path + ".part";
                await using (FileStream stream = File.Create(partial)) Png.Write(stream, frame.Width, frame.Height, frame.Rgba);
                File.Move(partial, path, overwrite: true);
                written++;
            }
        }
        catch (Exception e)
        {
            queue.Writer.TryComplete(e);
            throw;
        }
    }
}
