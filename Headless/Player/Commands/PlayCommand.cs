using System.Diagnostics;
using Headless.Engine;
using Headless.Player.Output;
using Headless.Player.Scripts;
using UnityEngine;

namespace Headless.Player.Commands;

/// <summary>
/// Plays a scene: frames, film, timings.csv, summary.json. The files are whole before Application.quitting is raised, so
/// that the project's own code can add to them there.
/// </summary>
internal sealed class PlayCommand(PlayOptions options)
{
    private readonly ConsoleLines console = new();

    public static int Run(PlayOptions options) => new PlayCommand(options).Run();

    private int Run()
    {
        string folder = PrepareFolder();
        using var interruption = new Interruption();
        using EngineSession session = EngineSession.Start(options.Project, options.Assemblies, options.Device, options.Validate, console.Write);
        string scene = session.Project.Index.AssetPathOf(options.Scene) is { } path && File.Exists(session.Project.Index.FileOf(path))
            ? path
            : throw new UsageException($"--scene: '{options.Scene}' is not a file of the project '{options.Project}'.");
        ScreenTarget.Resize(options.Width, options.Height);
        Time.captureDeltaTime = (float)(1 / options.Fps);
        if (options.ExecuteMethod is { } method)
        {
            // Play mode is on, so that the method may leave objects behind that outlive the loading of the scene.
            EngineState.IsPlaying = true;
            if (MethodRunner.Run(session.Scripts.FindMethod("--executeMethod", method)) is { } code) return code;
        }

        var timings = new TimingsFile(Path.Combine(folder, "timings.csv"));
        timings.Save();
        int frames;
        double wall;
        var clock = Stopwatch.StartNew();
        using (var writer = new FrameWriter(folder))
        {
            PlaySession.Begin(scene, session.Assemblies);
            frames = PlayFrames(writer, timings, interruption);
            writer.Finish();
            wall = clock.Elapsed.TotalSeconds;
        }
        timings.Save();
        WriteSummary(folder, scene, frames, wall);
        int exitCode = EngineState.ExitCode;
        PlaySession.End();
        bool valid = EngineSession.ReportValidation();
        Report(folder, frames, wall, interruption.Requested);
        return exitCode != 0 ? exitCode : valid ? 0 : 1;
    }

    private int PlayFrames(FrameWriter writer, TimingsFile timings, Interruption interruption)
    {
        var progress = new ProgressLine(Console.Out, !Console.IsOutputRedirected, options.Frames);
        console.Progress = progress;
        using var timer = new FrameTimer(timings.AddGpu);
        var readback = new ScreenReadback();
        var frameClock = new Stopwatch();
        int frame = 0;
        for (; frame < options.Frames && !interruption.Requested && !EngineState.QuitRequested; frame++)
        {
            frameClock.Restart();
            PlayerLoop.RunFrame();
            double cpu = frameClock.Elapsed.TotalMilliseconds;
            timings.AddFrame(frame, Time.timeAsDouble, cpu);
            if (options.Images)
            {
                readback.Capture(frame);
                TakeFrames(readback, writer, finish: false);
            }
            progress.Show(frame + 1, Time.timeAsDouble, frameClock.Elapsed.TotalMilliseconds);
        }
        TakeFrames(readback, writer, finish: true);
        timer.Finish();
        progress.End();
        console.Progress = null;
        return frame;
    }

    private static void TakeFrames(ScreenReadback readback, FrameWriter writer, bool finish)
    {
        while (readback.TryTake(finish, out CapturedFrame captured)) writer.Add(captured.Frame, captured.Width, captured.Height, captured.Pixels);
    }

    private string PrepareFolder()
    {
        string folder = Path.GetFullPath(options.Out);
        try
        {
            Directory.CreateDirectory(folder);
            // Frames of a longer run before would end up in this run's film.
            foreach (string old in Directory.EnumerateFiles(folder, "frame_*.png").Append(Path.Combine(folder, Film.FileName))) File.Delete(old);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            throw new UsageException($"--out: the folder '{options.Out}' cannot be written: {e.Message}");
        }
        return folder;
    }

    private void WriteSummary(string folder, string scene, int frames, double wall)
    {
        Vulkan.GpuDevice device = GraphicsDevice.Device;
        SummaryFile.Write(Path.Combine(folder, "summary.json"),
        [
            ("device", device.Adapter.Name), ("driver", device.Adapter.Driver), ("scene", scene),
            ("simulated_s", frames > 0 ? Time.timeAsDouble : 0), ("wall_s", wall),
            ("frames", frames), ("fps", options.Fps), ("width", options.Width), ("height", options.Height),
            ("gpu_memory_bytes", device.AllocatedBytes), ("errors", console.Errors),
            ("environment", EnvironmentVersions.Read()),
        ]);
    }

    private void Report(string folder, int frames, double wall, bool interrupted)
    {
        string shown = Path.GetRelativePath(Directory.GetCurrentDirectory(), folder);
        if (shown.StartsWith("..", StringComparison.Ordinal)) shown = folder;
        string? noFilm = options.Images ? Film.Make(folder, options.Fps, frames) : "no pictures were asked for.";
        if (options.Images && noFilm is not null) Console.Error.WriteLine("sphplayer: " + noFilm);
        Console.WriteLine(FormattableString.Invariant($"{(interrupted ? "interrupted: " : "")}{frames} frames in {wall:0.0} s on {GraphicsDevice.Device.Adapter.Name}"));
        Console.WriteLine($"{Path.Combine(shown, noFilm is null ? Film.FileName : "summary.json")}");
        if (console.Errors > 0) Console.Error.WriteLine($"sphplayer: {console.Errors} error(s) in the console, see above.");
    }
}
