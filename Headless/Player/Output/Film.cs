using System.ComponentModel;
using System.Diagnostics;
using System.Globalization;

namespace Headless.Player.Output;

/// <summary>
/// Makes <c>film.mp4</c> (H.264, 4:2:0, every browser plays it) with ffmpeg while the frames come, so that it is ready soon
/// after the last one. It appears under its name when it is whole.
/// </summary>
public sealed class Film : IDisposable
{
    public const string FileName = "film.mp4";

    private readonly string folder;
    private readonly string fps;
    private Process? process;
    private Task<string>? errors;
    private (int Width, int Height) size;
    private string? problem;

    public Film(string folder, double fps) => (this.folder, this.fps) = (folder, fps.ToString("R", CultureInfo.InvariantCulture));

    /// <summary>Whether there is no film for another reason than that the program which makes it is not installed.</summary>
    public bool HasFailed => problem is not null && problem != Missing;

    private string Unfinished => Path.Combine(folder, FileName + WholeFile.Ending);

    /// <param name="rgba">Top row first.</param>
    public void Add(int width, int height, byte[] rgba)
    {
        if (problem is not null) return;
        if (process is null) Start(width, height);
        if (problem is null && size != (width, height))
            problem = $"no film: the size of the pictures changed from {size.Width}x{size.Height} to {width}x{height}. The frames are in {folder}.";
        if (problem is not null) return;
        try
        {
            process!.StandardInput.BaseStream.Write(rgba, 0, 4 * width * height);
        }
        catch (IOException)
        {
            problem = Failure();
        }
    }

    /// <summary>Ends the film.</summary>
    /// <returns>Null when the film is there, else why not and what to do.</returns>
    public string? Finish()
    {
        if (process is null) return problem ??= "no film: there are no frames.";
        if (problem is null)
        {
            Close();
            process.WaitForExit();
            if (process.ExitCode != 0) problem = Failure();
            else File.Move(Unfinished, Path.Combine(folder, FileName), overwrite: true);
        }
        if (problem is not null) Discard();
        return problem;
    }

    /// <summary>Ends the film without a file.</summary>
    public void Discard()
    {
        if (process is not null)
        {
            Close();
            if (!process.HasExited) process.Kill(entireProcessTree: true);
            process.WaitForExit();
        }
        File.Delete(Unfinished);
    }

    public void Dispose()
    {
        if (process is { HasExited: false }) Discard();
        process?.Dispose();
        process = null;
    }

    private void Start(int width, int height)
    {
        size = (width, height);
        string[] arguments =
        [
            "-hide_banner", "-loglevel", "error", "-y",
            "-f", "rawvideo", "-pixel_format", "rgba", "-video_size", $"{width}x{height}", "-framerate", fps, "-i", "pipe:0",
            // 4:2:0 needs even sides.
            "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-c:v", "libx264", "-preset", "veryfast", "-crf", "18", "-pix_fmt", "yuv420p", "-movflags", "+faststart",
            "-f", "mp4", "file:" + Unfinished,
        ];
        try
        {
            // A Ctrl-C goes to the whole foreground group; setsid keeps it from ending the film before its end.
            bool detached = !OperatingSystem.IsWindows() && File.Exists("/usr/bin/setsid");
            var start = new ProcessStartInfo(detached ? "/usr/bin/setsid" : "ffmpeg", detached ? ["--wait", "ffmpeg", .. arguments] : arguments)
            {
                RedirectStandardInput = true,
                RedirectStandardError = true,
            };
            process = Process.Start(start)!;
            errors = process.StandardError.ReadToEndAsync();
        }
        catch (Win32Exception)
        {
            problem = Missing;
        }
    }

    private void Close()
    {
        try
        {
            process!.StandardInput.Close();
        }
        catch (IOException)
        {
            // It has ended already: its exit code tells why.
        }
    }

    private string Failure()
    {
        Close();
        process!.WaitForExit();
        return process.ExitCode == 127 ? Missing : $"no film: ffmpeg ended with code {process.ExitCode}: {Files.OneLine.Message(errors!.Result)}. The frames are in {folder}.";
    }

    private string Missing =>
        $"no film: ffmpeg is not installed (Debian: apt install ffmpeg; others: https://ffmpeg.org/download.html). The frames are in {folder}.";
}
