using System.Diagnostics;
using System.Globalization;
using System.Runtime.InteropServices;
using Headless.Measure.Children;
using Headless.Measure.Parts;
using Headless.Measure.Results;

namespace Headless.Measure;

/// <summary>Runs the parts one after the other; what each found is on the disk before the next one begins.</summary>
internal sealed class Measurement(MeasureOptions options)
{
    private const int SomeFailed = 1, Interrupted = 130;

    private readonly Stopwatch clock = Stopwatch.StartNew();
    private readonly CancellationTokenSource stop = new();
    private readonly List<PartResult> results = [];
    private ResultFolder folder = null!;

    public int Run()
    {
        folder = ResultFolder.Open(options.Out);
        using PosixSignalRegistration interrupt = PosixSignalRegistration.Create(PosixSignal.SIGINT, Stop);
        using PosixSignalRegistration terminate = PosixSignalRegistration.Create(PosixSignal.SIGTERM, Stop);
        Say($"SPH Fluid {options.Place.Commit}, {options.Seconds / 60:0.#} minutes at most{(options.Small ? ", small" : "")}; results: {folder.Path}");
        bool usable = true;
        for (int i = 0; i < options.Parts.Count; i++)
        {
            Part part = options.Parts[i];
            double limit = Budget.Of(options.Seconds - clock.Elapsed.TotalSeconds, options.Parts.Skip(i).Select(p => p.WeightOf(options.Small)), part.Least);
            results.Add(!usable ? LeftOut(part, "there is no device to run it on")
                : stop.IsCancellationRequested ? LeftOut(part, "interrupted")
                : limit < part.Least ? LeftOut(part, $"{limit:0} s were left for it, and it takes {part.Least:0} at least; --minutes gives more")
                : RunPart(part, limit));
            usable &= !part.IsNeeded || results[^1].Ending == ChildEnding.Done;
            folder.WriteParts(results);
            MeasurementPage.Write(folder.Path, options.Place);
        }
        Say($"done in {clock.Elapsed.TotalSeconds:0} s: {Path.Combine(folder.Path, MeasurementPage.FileName)}");
        return stop.IsCancellationRequested ? Interrupted : results.All(r => r.Ending is ChildEnding.Done or ChildEnding.LeftOut) ? 0 : SomeFailed;
    }

    private PartResult RunPart(Part part, double limit)
    {
        Say($"{part.Name}: {part.Question} ({limit:0} s at most)");
        double begun = clock.Elapsed.TotalSeconds;
        using var run = new PartRun(options, part, folder, TimeSpan.FromSeconds(limit), stop.Token);
        PartOutcome outcome;
        try
        {
            outcome = part.Body(run);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or FormatException or InvalidDataException or UsageException)
        {
            // A file that a child left unfinished.
            outcome = new PartOutcome(ChildEnding.Failed, [$"its results cannot be read: {e.Message}"]);
        }
        var result = new PartResult(part.Name, outcome.Ending, clock.Elapsed.TotalSeconds - begun, outcome.Lines);
        foreach (string line in outcome.Lines) Say("    " + line);
        Say($"{part.Name}: {ChildResult.Word(result.Ending)}, {result.Seconds:0} s");
        return result;
    }

    private PartResult LeftOut(Part part, string why)
    {
        Say($"{part.Name}: left out: {why}");
        return new PartResult(part.Name, ChildEnding.LeftOut, 0, [why]);
    }

    private void Say(FormattableString line) => Say(line.ToString(CultureInfo.InvariantCulture));

    private void Say(string line)
    {
        string text = string.Create(CultureInfo.InvariantCulture, $"[{clock.Elapsed.TotalSeconds,4:0} s] {line}");
        Console.WriteLine(text);
        folder.AddToSummary(text);
    }

    private void Stop(PosixSignalContext signal)
    {
        signal.Cancel = !stop.IsCancellationRequested;
        stop.Cancel();
    }
}
