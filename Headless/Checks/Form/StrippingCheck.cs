using Headless.Checks.Api;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;

namespace Headless.Checks.Form;

/// <summary>
/// Managed code stripping searches only assemblies whose types scenes use. One that is reached by
/// [RuntimeInitializeOnLoadMethod] alone is left out of a player unless it carries [assembly: AlwaysLinkAssembly].
/// </summary>
internal sealed class StrippingCheck(ProjectPackages packages)
{
    public CheckReport Run()
    {
        var report = new CheckReport("code stripping");
        var initialised = 0;
        foreach (var assembly in PackageAssembly.FindAll(packages).Where(a => !a.IsTest && !a.EditorOnly))
        {
            var roots = assembly.Parse([]).Select(t => t.GetCompilationUnitRoot()).ToList();
            var methods = roots.SelectMany(r => r.DescendantNodes().OfType<MethodDeclarationSyntax>()).ToList();
            if (!methods.Exists(m => m.AttributeLists.Has("RuntimeInitializeOnLoadMethod"))) continue;
            initialised++;
            var inScenes = roots.Exists(r => r.DescendantNodes().OfType<ClassDeclarationSyntax>().Any(c => c.HasUnityBase()));
            var linked = roots.Exists(r => r.AttributeLists.Has("AlwaysLinkAssembly"));
            if (!inScenes && !linked)
                report.Findings.Add($"{assembly.Name} is reached by [RuntimeInitializeOnLoadMethod] alone: players drop it without [assembly: AlwaysLinkAssembly]");
        }
        report.Figures = $"{initialised} assemblies with methods that run on load";
        return report;
    }
}
