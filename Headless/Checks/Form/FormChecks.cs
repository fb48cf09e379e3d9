namespace Headless.Checks.Form;

/// <summary>Everything that the Editor expects of files, and what users would meet first if it were wrong.</summary>
internal static class FormChecks
{
    public static IEnumerable<CheckReport> Run(string project, string package) =>
    [
        new PackageManifestCheck(package).Run(),
        new MetaFileCheck(project).Run(),
        new SerializedFieldCheck(package).Run(),
        new GetterCheck(package).Run(),
        new InspectorCheck(package).Run(),
        new StrippingCheck(package).Run(),
        new MenuPathCheck(project).Run(),
        new MaterialCheck(project).Run(),
        new SceneLightCheck(project).Run(),
        new ProjectSettingsCheck(project).Run(),
        new AssemblyProjectCheck(project).Run(),
        new ShaderApiCheck(package).Run(),
    ];
}
