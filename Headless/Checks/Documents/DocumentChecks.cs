namespace Headless.Checks.Documents;

/// <summary>What the documents name is there: links, menus, commands, files, fields, and code that compiles.</summary>
internal static class DocumentChecks
{
    public static IEnumerable<CheckReport> Run(ProjectPackages packages) =>
    [
        new LinkCheck(packages).Run(),
        new MenuPathCheck(packages).Run(),
        new CommandCheck(packages).Run(),
        new FileNameCheck(packages).Run(),
        new BenchmarkTableCheck(packages).Run(),
        new FieldNameCheck(packages).Run(),
        new SnippetCheck(packages).Run(),
        new SupportedUnityCheck(packages).Run(),
    ];
}
