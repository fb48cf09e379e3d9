namespace Headless.Checks.Documents.Facts;

/// <summary>What documents claim is so: facts that they mark, numbers that they should, methods, pictures, tables and the claims of the front page.</summary>
internal static class FactChecks
{
    /// <param name="packages">The project's packages.</param>
    /// <param name="standIn">Folder of the stand-in for Unity.</param>
    /// <param name="update">Whether facts and the list of claims are written anew.</param>
    public static IEnumerable<CheckReport> Run(ProjectPackages packages, string standIn, bool update)
    {
        MethodFacts program;
        try
        {
            program = new MethodFacts(packages, new PackageProgram(standIn, Path.Combine(packages.Project, "Build", "ScriptAssemblies")));
        }
        catch (UnknownFactException e)
        {
            var report = new CheckReport("facts");
            report.Findings.Add(e.Message);
            return [report];
        }
        return
        [
            new FactCheck(packages, FactSources.Of(packages, program)).Run(update),
            new TypedFactCheck(packages).Run(),
            new MethodClaimCheck(packages, program.With).Run(),
            new PictureCheck(packages).Run(),
            new DatedTableCheck(packages).Run(),
            new ClaimCheck(packages).Run(update),
        ];
    }
}
