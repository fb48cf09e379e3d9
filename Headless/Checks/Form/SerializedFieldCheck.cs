using Microsoft.CodeAnalysis.CSharp.Syntax;

namespace Headless.Checks.Form;

/// <summary>Every serialised field that the inspector shows carries a [Tooltip]. (XML documentation of public members
/// is held by the API check: a missing one is warning CS1591 there.)</summary>
internal sealed class SerializedFieldCheck(ProjectPackages packages)
{
    public CheckReport Run()
    {
        var report = new CheckReport("tooltips");
        var fields = 0;
        foreach (var (file, type) in PackageTypes.OfPlayers(packages).Where(t => IsSerialized(t.Type)))
            foreach (var field in type.Members.OfType<FieldDeclarationSyntax>().Where(IsShown))
            {
                fields++;
                if (!field.AttributeLists.Has("Tooltip"))
                    report.Findings.Add($"{file}: {type.Identifier}.{field.Declaration.Variables[0].Identifier} has no [Tooltip]");
            }
        report.Figures = $"{fields} serialised fields with a tooltip";
        return report;
    }

    private static bool IsSerialized(TypeDeclarationSyntax type) => type.AttributeLists.Has("Serializable") || type.HasUnityBase();

    private static bool IsShown(FieldDeclarationSyntax field)
    {
        var modifiers = field.Modifiers.Select(m => m.Text).ToList();
        if (modifiers.Contains("static") || modifiers.Contains("const") || modifiers.Contains("readonly")) return false;
        if (field.AttributeLists.Has("NonSerialized") || field.AttributeLists.Has("HideInInspector")) return false;
        return modifiers.Contains("public") || field.AttributeLists.Has("SerializeField");
    }
}
