namespace Headless.Help;

/// <summary>
/// The files that <c>./run --help</c> shows. They are made from the tables and committed, so that help is there before anything is built;
/// a test fails where they differ from the tables.
/// </summary>
internal static class HelpFiles
{
    /// <summary>Below the project's folder.</summary>
    public const string Folder = "Headless/Help/Texts";

    /// <summary>Name and content.</summary>
    public static IEnumerable<(string Name, string Content)> All()
    {
        yield return ("run.txt", HelpText.Overview(Verbs.All));
        foreach (Verb verb in Verbs.All) yield return ($"{verb.Name}.txt", HelpText.Of(verb));
        yield return ("flags.sh", ShellTable.Of(Verbs.All));
    }

    /// <summary>Names of files that differ, are missing or are too many.</summary>
    public static IEnumerable<string> Stale(string project)
    {
        string folder = Path.Combine(project, Folder);
        (string Name, string Content)[] all = [.. All()];
        IEnumerable<string> there = Directory.Exists(folder) ? Directory.EnumerateFiles(folder).Select(f => Path.GetFileName(f)) : [];
        return all.Where(f => !File.Exists(Path.Combine(folder, f.Name)) || File.ReadAllText(Path.Combine(folder, f.Name)) != f.Content).Select(f => f.Name)
            .Concat(there.Except(all.Select(f => f.Name))).Order(StringComparer.Ordinal);
    }

    public static void Write(string project)
    {
        string folder = Path.Combine(project, Folder);
        Directory.CreateDirectory(folder);
        foreach (string file in Directory.EnumerateFiles(folder)) File.Delete(file);
        foreach (var (name, content) in All()) File.WriteAllText(Path.Combine(folder, name), content);
    }
}
