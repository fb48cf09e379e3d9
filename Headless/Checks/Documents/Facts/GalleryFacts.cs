using System.Text.Json;
using System.Text.RegularExpressions;

namespace Headless.Checks.Documents.Facts;

/// <summary><c>gallery:samples</c>: every sample of the packages with its picture and what its package.json says; <c>gallery:twelve</c>: the first twelve pictures for a front page.</summary>
internal sealed partial class GalleryFacts(ProjectPackages packages, PictureFacts pictures)
{
    private const int Row = 3, OnFrontPage = 12;

    private sealed record Sample(string Package, string Name, string Description, string Path);

    public string Find(string[] words) => words switch
    {
        ["samples"] => Table(),
        ["twelve"] => Tiles(),
        _ => throw new UnknownFactException("it is none of gallery:samples and gallery:twelve"),
    };

    private string Table() => "| Sample | What it shows | |\n|---|---|---|\n" + string.Concat(Samples(packages.Product)
        .Select(s => $"| [{s.Name}](../{s.Path}/README.md) | {s.Description} | {(Picture(s) is { } p ? $"![{s.Name}](images/{Path.GetFileName(p.File)})" : "")} |\n"));

    private string Tiles()
    {
        var shown = Samples(packages.Product).Select(s => (Sample: s, Picture: Picture(s))).Where(s => s.Picture is not null).Take(OnFrontPage).ToList();
        return $"|{string.Concat(Enumerable.Repeat(" |", Row))}\n|{string.Concat(Enumerable.Repeat("---|", Row))}\n" + string.Concat(shown.Chunk(Row)
            .Select(row => $"| {string.Join(" | ", row.Select(s => $"![{s.Sample.Name}]({Below(s.Picture!.File)})<br>{s.Sample.Name}"))} |\n"));
    }

    private string Below(string file) => Path.GetRelativePath(packages.Project, file).Replace('\\', '/');

    // PourAndFill has pour-and-fill, FallingBlock falling-block-water.
    private PictureRecord? Picture(Sample sample)
    {
        var name = Word().Replace(Path.GetFileName(sample.Path), "-").ToLowerInvariant();
        return pictures.All.FirstOrDefault(p => p.Name == name) ?? pictures.All.FirstOrDefault(p => p.Name == name + "-water");
    }

    private static List<Sample> Samples(string package)
    {
        using var json = JsonDocument.Parse(File.ReadAllText(Path.Combine(package, "package.json")));
        return !json.RootElement.TryGetProperty("samples", out var samples) ? [] : [.. samples.EnumerateArray().Select(s =>
            new Sample(package, s.GetProperty("displayName").GetString()!, s.GetProperty("description").GetString()!, s.GetProperty("path").GetString()!))];
    }

    [GeneratedRegex("(?<=[a-z])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])")] private static partial Regex Word();
}
