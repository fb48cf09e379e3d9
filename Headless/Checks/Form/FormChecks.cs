namespace Headless.Checks.Form;

/// <summary>Everything that the Editor expects of files, and what users would see first if it were wrong.</summary>
internal static class FormChecks
{
    public static IEnumerable<CheckReport> Run(ProjectPackages packages) =>
    [
        .. packages.All.Select(package => new PackageManifestCheck(package).Run()),
        new MetaFileCheck(packages).Run(),
        new SerializedFieldCheck(packages).Run(),
        new GetterCheck(packages).Run(),
        new StaticStateCheck(packages).Run(),
        new InspectorCheck(packages).Run(),
        new StrippingCheck(packages).Run(),
        new MaterialCheck(packages).Run(),
        new SceneLightCheck(packages).Run(),
        new ProjectSettingsCheck(packages).Run(),
        new AssemblyProjectCheck(packages).Run(),
        new ShaderApiCheck(packages).Run(),
        new PassLayoutCheck(packages).Run(),
    ];
}
