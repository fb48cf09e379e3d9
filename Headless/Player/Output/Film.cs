using System.ComponentModel;
using System.Diagnostics;
using System.Globalization;

namespace Headless.Player.Output;

/// <summary>Makes <c>film.mp4</c> (H.264, 4:2:0, every browser plays it) of the frames with ffmpeg.</summary>
public static class Film
{
    public const string FileName = "film.mp4";

    /// <returns>Null when the film was made, else why not and what to do.</returns>
    public static string? Make(string folder, double fps, int frames)
    {
        if (frames == 0) return "no film: there are no frames.";
        string[] arguments =
        [
            "-hide_banner", "-loglevel", "error", "-nostdin", "-y",
            "-framerate", fps.ToString("R", CultureInfo.InvariantCulture), "-i", Path.Combine(folder, "frame_%05d.png"), "-frames:v", frames.ToString(CultureInfo.InvariantCulture),
            // 4:2:0 needs even sides.
            "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-c:v", "libx264", "-preset", "veryfast", "-crf", "18", "-pix_fmt", "yuv420p", "-movflags", "+faststart",
            "-f", "mp4", Path.Combine(folder, FileName + ".part"),
        ];
        try
        {
            // A Ctrl-C goes to the whole foreground group; setsid keeps it from ending the film half way.
            bool detached = File.Exists("/usr/bin/setsid");
            var start = new ProcessStartInfo(detached ? "/usr/bin/setsid" : "ffmpeg", detached ? ["--wait", "ffmpeg", .. arguments] : arguments) { RedirectStandardError = true };
            using Process process = Process.Start(start)!;
            string errors = process.StandardError.ReadToEnd().Trim();
            process.WaitForExit();
            if (detached && process.ExitCode == 127) return Missing(folder);
            if (process.ExitCode != 0) return $"no film: ffmpeg ended with code {process.ExitCode}: {errors}. The frames are in {folder}.";
            File.Move(Path.Combine(folder, FileName + ".part"), Path.Combine(folder, FileName), overwrite: true);
            return null;
        }
        catch (Win32Exception)
        {
            return Missing(folder);
        }
    }

    private static string Missing(string folder) =>
        $"no film: ffmpeg is not installed (Debian: apt install ffmpeg; others: https://ffmpeg.org/download.html). The frames are in {folder}.";
}
