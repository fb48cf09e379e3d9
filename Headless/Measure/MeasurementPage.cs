using System.Reflection;
using System.Text.Json;
using Headless.Measure.Page;
using Headless.Measure.Results;
using SphFluid.Validation;

namespace Headless.Measure;

/// <summary>A folder of results as one page that needs no other file: tables, plots against the model's estimates, pictures.</summary>
internal static class MeasurementPage
{
    public const string FileName = "report.html";

    /// <summary>Style and scripts that the chart's report has too, in the project.</summary>
    private const string ReportFolder = "Packages/com.sphfluid.validation/Runtime/Chart/Report/Page";

    /// <summary>Reads a folder whose measurement has ended.</summary>
    /// <exception cref="UsageException">No measurement wrote it.</exception>
    public static int WriteAgain(string folder, Workplace place)
    {
        if (!File.Exists(Path.Combine(folder, ResultFolder.Parts)))
            throw new UsageException($"--page: '{folder}' has no {ResultFolder.Parts}; name a folder that a measurement wrote.");
        Write(folder, place);
        Console.WriteLine(Path.Combine(folder, FileName));
        return 0;
    }

    public static void Write(string folder, Workplace place)
    {
        var tables = new MeasuredTables(folder);
        var steps = new MeasuredSteps(folder, Estimates.Read(place.Model));
        string summary = Path.Combine(folder, ResultFolder.Summary);
        string device = tables.Device ?? "no device";
        var parts = new Dictionary<string, string>
        {
            ["title"] = ReportWords.Html($"SPH Fluid on {device}"),
            ["style"] = Text(place, "report.css.txt"),
            ["facts"] = Facts(("Device", tables.DeviceLine ?? device), ("Date", $"{File.GetLastWriteTimeUtc(summary):yyyy-MM-dd}"), ("Build", place.Commit)),
            ["parts"] = tables.Parts().ToString(),
            ["steps"] = steps.Table().ToString(),
            ["frames"] = tables.Frames().ToString(),
            ["surfaces"] = tables.Surfaces().ToString(),
            ["accuracy"] = tables.Accuracy().ToString(),
            ["pictures"] = string.Concat(Directory.EnumerateFiles(folder, "*.png").Order(StringComparer.Ordinal).Select(Picture)),
            ["summary"] = ReportWords.Html(File.Exists(summary) ? File.ReadAllText(summary) : ""),
            ["data"] = Data(("steps", steps.Plot()), ("frames", tables.FramePlot())),
            ["script"] = string.Join('\n', Text(place, "numbers.js.txt"), Text(place, "elements.js.txt"), Resource("plots.js")),
        };
        // What is filled in is not looked through again.
        string[] pieces = Resource("measured.html").Split(["{{", "}}"], StringSplitOptions.None);
        for (int i = 1; i < pieces.Length; i += 2) pieces[i] = parts[pieces[i]];
        string file = Path.Combine(folder, FileName), unfinished = file + ".new";
        File.WriteAllText(unfinished, string.Concat(pieces));
        File.Move(unfinished, file, overwrite: true);
    }

    private static string Facts(params (string Name, string Value)[] facts) =>
        string.Concat(facts.Select(f => $"<div><dt>{f.Name}</dt><dd>{ReportWords.Html(f.Value)}</dd></div>"));

    private static string Picture(string file)
    {
        string name = ReportWords.Html(Path.GetFileNameWithoutExtension(file));
        return $"<figure><img alt=\"{name}\" src=\"data:image/png;base64,{Convert.ToBase64String(File.ReadAllBytes(file))}\"/><figcaption>{name}</figcaption></figure>";
    }

    // The writer leaves no character that HTML knows.
    private static string Data(params (string Name, Plot Plot)[] plots)
    {
        using var stream = new MemoryStream();
        using (var json = new Utf8JsonWriter(stream))
        {
            json.WriteStartObject();
            foreach ((string name, Plot plot) in plots) plot.Write(json, name);
            json.WriteEndObject();
        }
        return System.Text.Encoding.UTF8.GetString(stream.ToArray());
    }

    private static string Text(Workplace place, string file) => File.ReadAllText(Path.Combine(place.Project, ReportFolder, file)).ReplaceLineEndings("\n");

    private static string Resource(string name)
    {
        using var reader = new StreamReader(Assembly.GetExecutingAssembly().GetManifestResourceStream(name)!);
        return reader.ReadToEnd();
    }
}
