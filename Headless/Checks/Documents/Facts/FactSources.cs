namespace Headless.Checks.Documents.Facts;

/// <summary>A name that no source has, or a source that has no such fact.</summary>
internal sealed class UnknownFactException(string message) : Exception(message);

/// <summary>Where facts come from, by the first word of their names: <c>count:cases</c> is asked of the source <c>count</c>.</summary>
internal sealed class FactSources(IReadOnlyDictionary<string, Func<string[], string>> sources)
{
    private readonly Dictionary<string, string> known = [];

    /// <summary>Those of a project.</summary>
    /// <param name="packages">The project's packages.</param>
    /// <param name="methods">What the compiled package says of its methods.</param>
    public static FactSources Of(ProjectPackages packages, MethodFacts methods)
    {
        var code = new Lazy<CodeFacts>(() => new CodeFacts(packages));
        var counts = new CountFacts(packages, code);
        var pictures = new Lazy<PictureFacts>(() => new PictureFacts(packages));
        var tables = new TableFacts(packages.Project);
        return new FactSources(new Dictionary<string, Func<string[], string>>
        {
            ["methods"] = words => methods.Find(words),
            ["bytes"] = words => methods.Bytes(words),
            ["requires"] = words => methods.Requires(words),
            ["default"] = words => code.Value.Default(words),
            ["const"] = words => code.Value.Constant(words),
            ["asset"] = words => new AssetFacts(packages).Find(words),
            ["names"] = words => new AssetFacts(packages).Names(words),
            ["count"] = counts.Find,
            ["picture"] = words => pictures.Value.Find(words),
            ["gallery"] = words => new GalleryFacts(packages, pictures.Value).Find(words),
            ["csv"] = tables.Find,
            ["peers"] = _ => PeerTable.Read(packages.Project).Markdown,
        });
    }

    /// <exception cref="UnknownFactException">There is no such fact.</exception>
    public string Find(string name)
    {
        if (known.TryGetValue(name, out var value)) return value;
        var words = name.Split(':');
        if (!sources.TryGetValue(words[0], out var source)) throw new UnknownFactException($"'{words[0]}' is none of {string.Join(", ", sources.Keys)}");
        return known[name] = source(words[1..]);
    }
}
