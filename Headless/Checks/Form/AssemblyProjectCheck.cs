using Headless.Checks.Api;
using System.Xml.Linq;

namespace Headless.Checks.Form;

/// <summary>One csproj an assembly definition, with equal references. Optional assemblies have none: the player does not have the packages they are for.</summary>
internal sealed class AssemblyProjectCheck(ProjectPackages packages)
{
    // What every script assembly sees without naming it in its assembly definition.
    private static readonly string[] implicitReferences = ["UnityEngine", "UnityEditor"];

    public CheckReport Run()
    {
        var report = new CheckReport("projects of assembly definitions");
        var assemblies = PackageAssembly.FindAll(packages).FindAll(a => !a.IsOptional);
        foreach (var assembly in assemblies)
        {
            var project = Path.Combine(packages.Project, "Headless", "Package", assembly.Name, assembly.Name + ".csproj");
            if (!File.Exists(project)) { report.Findings.Add($"{assembly.Name}.asmdef has no {Path.GetRelativePath(packages.Project, project)}"); continue; }
            var actual = XDocument.Load(project).Descendants("ProjectReference").Select(r => Path.GetFileNameWithoutExtension(r.Attribute("Include")!.Value.Replace('\\', '/')))
                .Except(implicitReferences).Order().ToList();
            var expected = assembly.References.Except(implicitReferences).Order().ToList();
            if (!actual.SequenceEqual(expected))
                report.Findings.Add($"{assembly.Name}: the csproj references {string.Join(", ", actual)}, the asmdef {string.Join(", ", expected)}");
        }
        report.Figures = $"{assemblies.Count} assemblies";
        return report;
    }
}
