namespace Headless.Checks.Form;

/// <summary>Every [CustomEditor] also carries [CanEditMultipleObjects]: else two selected objects show nothing.</summary>
internal sealed class InspectorCheck(ProjectPackages packages)
{
    public CheckReport Run()
    {
        var report = new CheckReport("inspectors");
        var editors = 0;
        foreach (var (file, type) in PackageTypes.OfEditor(packages).Where(t => t.Type.AttributeLists.Has("CustomEditor")))
        {
            editors++;
            if (!type.AttributeLists.Has("CanEditMultipleObjects"))
                report.Findings.Add($"{file}: {type.Identifier} has no [CanEditMultipleObjects]");
        }
        report.Figures = $"{editors} custom editors, each for several objects";
        return report;
    }
}
