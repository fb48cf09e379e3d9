using Headless.Checks.Documents.Facts;

namespace Headless.Checks.Documents;

/// <summary>What the documents name is there: links, menus, commands, files, fields, and code that compiles; and what they claim is so.</summary>
internal static class DocumentChecks
{
    /// <param name="packages">The project's packages.</param>
    /// <param name="standIn">Folder of the stand-in for Unity, which the compiled package is asked with.</param>
    /// <param name="update">Whether facts are written anew.</param>
    public static IEnumerable<CheckReport> Run(ProjectPackages packages, string standIn, bool update) =>
    [
        new LinkCheck(packages).Run(),
        new MenuPathCheck(packages).Run(),
        new CommandCheck(packages).Run(),
        new FileNameCheck(packages).Run(),
        new BenchmarkTableCheck(packages).Run(),
        new FieldNameCheck(packages).Run(),
        new SnippetCheck(packages).Run(),
        new SupportedUnityCheck(packages).Run(),
        .. FactChecks.Run(packages, standIn, update),
    ];
}
