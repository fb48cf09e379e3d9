using Headless.Checks.Api;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;

namespace Headless.Checks.Form;

/// <summary>Every [CustomEditor] also carries [CanEditMultipleObjects]: else two selected objects show nothing.</summary>
internal sealed class InspectorCheck(string packageRoot)
{
    public CheckReport Run()
    {
        var report = new CheckReport("inspectors");
        var editors = 0;
        foreach (var assembly in PackageAssembly.FindAll(packageRoot).Where(a => !a.IsTest))
            foreach (var tree in assembly.Parse(["UNITY_EDITOR"]))
                foreach (var type in tree.GetCompilationUnitRoot().DescendantNodes().OfType<ClassDeclarationSyntax>())
                {
                    if (!type.AttributeLists.Has("CustomEditor")) continue;
                    editors++;
                    if (!type.AttributeLists.Has("CanEditMultipleObjects"))
                        report.Findings.Add($"{Path.GetFileName(tree.FilePath)}: {type.Identifier} has no [CanEditMultipleObjects]");
                }
        report.Figures = $"{editors} custom editors, each for several objects";
        return report;
    }
}
