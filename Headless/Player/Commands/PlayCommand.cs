using System.Diagnostics;
using System.Runtime.ExceptionServices;
using Headless.Engine;
using Headless.Files;
using Headless.Importers.Assets;
using Headless.Player.Output;
using Headless.Player.Scripts;
using Headless.Shaders;
using UnityEngine;

namespace Headless.Player.Commands;

/// <summary>
/// Plays a scene: frames, film, timings.csv, summary.json. The files are whole before Application.quitting is raised, so
/// that the project's own code can add to them there. Errors in the console: the frames stay, but no film pretends that
/// all is well, and the exit code is 1.
/// </summary>
internal sealed class PlayCommand : IDisposable
{
    private const int Failed = 1;
    /// <summary>A few frames at most are waiting, a tenth of a second each; a busy machine gets more time.</summary>
    private static readonly TimeSpan LastFrames = TimeSpan.FromSeconds(5);

    private static readonly TimeSpan EnvironmentPatience = TimeSpan.FromSeconds(0.2);

    // Asking the system for its packages takes a moment that an interrupted run does not have.
    private readonly Task<IReadOnlyList<(string Key, string Version)>> environment = Task.Run(EnvironmentVersions.Read);
    private readonly PlayOptions options;
    private readonly ConsoleLines console = new();
    private readonly Interruption interruption = new();
    private readonly Stopwatch clock = new();
    private OutputFolder folder = null!;
    private TimingsFile timings = null!;
    private readonly SecondPlay? second;
    private FrameWriter? writer;
    private Film? film;
    private string scene = "";
    private int frames;

    private PlayCommand(PlayOptions options)
    {
        this.options = options;
        if (options.Twice) second = new SecondPlay();
    }

    public static int Run(PlayOptions options)
    {
        using var command = new PlayCommand(options);
        return command.Run();
    }

    public void Dispose()
    {
        film?.Dispose();
        interruption.Dispose();
    }

    private string SummaryPath => Path.Combine(folder.Path, SummaryFile.FileName);

    private int Run()
    {
        using var activity = new ActivityLine(Console.Out, !Console.IsOutputRedirected);
        console.Activity = activity;
        EngineHooks.CompilerMissing = console.EndWithoutCompiler;
        activity.Begin("opening the project");
        using EngineSession session = EngineSession.Start(
            options.Project, options.Assemblies, options.Device, options.Validate, console.Write, options.Pipeline);
        StereoChoice.Apply(options.Stereo);
        if (session.PipelineNotice is { } notice) console.Write(LogType.Log, notice);
        if (options.Twice) EngineSession.RequireStaticsThatStay("--twice");
        ShaderCompiler compiler = GraphicsDevice.Compiler;
        activity.Detail = () => compiler.Activity ?? (ProjectAssets.Importing is { } asset ? "importing " + asset : null);
        scene = session.Project.Index.AssetPathOf(options.Scene) is { } path && File.Exists(session.Project.Index.FileOf(path))
            ? path
            : throw new UsageException($"--scene: '{options.Scene}' is not a file of the project '{options.Project}'.");
        using OutputFolder output = OutputFolder.Open(options.Out, options.Images ? options.Frames : 0, options.Images);
        folder = output;
        ScreenTarget.Resize(options.Width, options.Height);
        Time.captureDeltaTime = (float)(1 / options.Fps);
        if (options.ExecuteMethod is { } method)
        {
            // Play mode is on, so that the method may leave objects behind that outlive the loading of the scene.
            EngineState.IsPlaying = true;
            if (MethodRunner.Run(session.Scripts.FindMethod("--executeMethod", method)) is { } code) return code;
        }
        timings = new TimingsFile(Path.Combine(folder.Path, TimingsFile.FileName));
        if (options.Images) film = new Film(folder.Path, options.Fps);
        try
        {
            using (writer = new FrameWriter(folder.Path, film, path => activity.Say("first frame: " + Shown(path)))) return Play(session, activity);
        }
        finally
        {
            // Without results of this run there is nothing that the project's code may add to as it quits.
            if (frames == 0) EngineState.IsPlaying = false;
        }
    }

    private int Play(EngineSession session, ActivityLine activity)
    {
        clock.Start();
        ExceptionDispatchInfo? stopped = null;
        interruption.EndFiles = EndFilesElsewhere;
        interruption.Heard = () => activity.Say(Message.Of(
            $"stopping after this frame; {(options.Images ? "the film of the frames so far follows" : "the figures so far are kept")}. Ctrl-C again ends at once."));
        try
        {
            if (options.Unset) UnsetProperties.Watch();
            activity.Begin("loading the scene");
            PlaySession.Begin(scene, session.Assemblies);
            if (Refused) return EngineState.ExitCode;
            PlayFrames(activity);
        }
        catch (Exception e) when (e is BadFileException or Vulkan.GpuException or IOException or UnauthorizedAccessException)
        {
            // What there is so far is kept.
            if (frames == 0) throw;
            stopped = ExceptionDispatchInfo.Capture(e);
        }
        if (Refused) return EngineState.ExitCode;
        interruption.EndHere();
        activity.End();
        foreach (string property in UnsetProperties.Found) Console.WriteLine("unset: " + property);
        SaveFigures(stopped is not null);
        int exitCode = EngineState.ExitCode;
        PlaySession.End();
        if (stopped is null && exitCode == 0 && console.Errors == 0 && !interruption.Requested) second?.Run(scene, session.Assemblies, activity, interruption);
        bool valid = EngineSession.ReportValidation();
        if (stopped is null) SummaryFile.Change(SummaryPath, "errors", console.Errors);
        Report(stopped is not null);
        stopped?.Throw();
        if (exitCode != 0) return exitCode;
        if (interruption.Requested) return Interruption.ExitCode;
        return valid && console.Errors == 0 && second?.Difference is null && film is not { HasFailed: true } ? 0 : Failed;
    }

    private void SaveFigures(bool stopped)
    {
        try
        {
            folder.Begin();
            timings.Save();
            WriteSummary();
        }
        catch (Exception e) when (stopped && e is (IOException or UnauthorizedAccessException))
        {
            // As on a full disk: why the play stopped is said at the end.
        }
    }

    /// <summary>The project's code has said by the end of the first frame why it cannot go on, as for a wrong flag: there is nothing to show, and no file changes.</summary>
    private bool Refused => frames == 0 && EngineState.QuitRequested && EngineState.ExitCode != 0;

    private void PlayFrames(ActivityLine activity)
    {
        var progress = new ProgressLine(activity, options.Frames, options.Images ? $" of {options.Width}x{options.Height}" : "");
        using var timer = new FrameTimer((frame, milliseconds, passes) =>
        {
            timings.AddGpu(frame, milliseconds, passes);
            if (!options.Images) progress.Finished(frame + 1, clock.Elapsed.TotalSeconds);
        });
        var readback = new ScreenReadback();
        var frameClock = new Stopwatch();
        for (int frame = 0; frame < options.Frames && !interruption.Requested && !EngineState.QuitRequested; frame++)
        {
            frameClock.Restart();
            progress.Begin(frame, clock.Elapsed.TotalSeconds);
            PlayerLoop.RunFrame();
            double cpu = frameClock.Elapsed.TotalMilliseconds;
            if (Refused) return;
            folder.Begin();
            timings.AddFrame(frame, Time.timeAsDouble, cpu);
            frames = frame + 1;
            if (frame == 0 && options.Images) SceneNotices.Write(console.Write);
            if (options.Images)
            {
                readback.Capture(frame);
                // The first one is to be seen as soon as it is there.
                TakeFrames(readback, progress, finish: frame == 0);
            }
            progress.Show(Time.timeAsDouble, clock.Elapsed.TotalSeconds);
        }
        interruption.Acknowledge();
        TakeFrames(readback, progress, finish: true);
        writer!.Finish();
        timer.Finish();
        progress.Finished(frames, clock.Elapsed.TotalSeconds);
        progress.Show(Time.timeAsDouble, clock.Elapsed.TotalSeconds, last: true);
    }

    private void TakeFrames(ScreenReadback readback, ProgressLine progress, bool finish)
    {
        while (readback.TryTake(finish, out CapturedFrame captured))
        {
            progress.Finished(captured.Frame + 1, clock.Elapsed.TotalSeconds);
            second?.Remember(captured);
            writer!.Add(captured.Frame, captured.Width, captured.Height, captured.Pixels);
        }
    }

    /// <summary>On the interrupting thread, while the main thread is somewhere in a frame.</summary>
    private void EndFilesElsewhere()
    {
        bool whole = writer!.Stop(LastFrames);
        folder.Begin();
        timings.Save();
        frames = Math.Min(frames, options.Images ? writer.Written : frames);
        WriteSummary();
        console.Activity?.End();
        if (whole) Report(false);
        else Console.Error.WriteLine(Message.Of($"interrupted; no film: the last frame was still being written. {writer.Written} frames are in {folder.Path}."));
    }

    private void WriteSummary()
    {
        Vulkan.GpuDevice device = GraphicsDevice.Device;
        SummaryFile.Write(SummaryPath,
        [
            ("device", device.Adapter.Name), ("driver", device.Adapter.Driver), ("processor", SystemInfo.processorType), ("scene", scene),
            ("simulated_s", frames > 0 ? Time.timeAsDouble : 0), ("wall_s", clock.Elapsed.TotalSeconds),
            ("frames", frames), ("fps", options.Fps), ("width", options.Width), ("height", options.Height),
            ("gpu_memory_bytes", device.AllocatedBytes), ("interrupted", interruption.Requested), ("errors", console.Errors),
            ("environment", environment.Wait(EnvironmentPatience) ? environment.Result : null),
        ]);
    }

    private void Report(bool stopped)
    {
        string? noFilm = FinishFilm(stopped);
        // The list of the beginning names more than was written, and a full disk has no room for another.
        if (!stopped) folder.Close(writer!.Written, options.Images && noFilm is null);
        if (options.Images && noFilm is not null) Console.Error.WriteLine(Message.Of(noFilm));
        Console.WriteLine(FormattableString.Invariant($"{(interruption.Requested ? "interrupted: " : "")}{frames} frames in {clock.Elapsed.TotalSeconds:0.0} s on {GraphicsDevice.Device.Adapter.Name}"));
        string result = Path.Combine(folder.Path, noFilm is null ? Film.FileName : SummaryFile.FileName);
        if (File.Exists(result)) Console.WriteLine(Shown(result));
        if (second?.Difference is { } difference) Console.Error.WriteLine(Message.Of($"--twice: {difference}"));
        if (options.Open && !interruption.Requested && noFilm is null && FilmViewer.Open(result) is { } unseen)
            Console.Error.WriteLine(Message.Of($"--open: {unseen}; the film is {Shown(result)}."));
    }

    private static string Shown(string path)
    {
        string shown = Path.GetRelativePath(Directory.GetCurrentDirectory(), path);
        return shown.StartsWith("..", StringComparison.Ordinal) ? path : shown;
    }

    private string? FinishFilm(bool stopped)
    {
        if (film is null) return "no pictures were asked for.";
        if (console.Errors == 0 && !stopped) return film.Finish();
        film.Discard();
        if (stopped) return $"no film: the play stopped early. What there is of it is in {folder.Path}.";
        string errors = console.Errors == 1 ? "was 1 error" : $"were {console.Errors} errors";
        return $"no film: there {errors} in the console, see above. {writer!.Written} frames, {TimingsFile.FileName} and {SummaryFile.FileName} are in {folder.Path}.";
    }
}
