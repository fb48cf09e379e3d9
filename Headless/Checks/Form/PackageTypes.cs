using Headless.Checks.Api;
using Microsoft.CodeAnalysis.CSharp.Syntax;

namespace Headless.Checks.Form;

/// <summary>Types of the packages' assemblies as they are written, each with the name of its file.</summary>
internal static class PackageTypes
{
    /// <summary>What a player has of the packages.</summary>
    public static IEnumerable<(string File, TypeDeclarationSyntax Type)> OfPlayers(ProjectPackages packages) =>
        Of(packages, a => !a.IsTest && !a.EditorOnly, []);

    /// <summary>What the Editor has of the packages, without their tests.</summary>
    public static IEnumerable<(string File, TypeDeclarationSyntax Type)> OfEditor(ProjectPackages packages) =>
        Of(packages, a => !a.IsTest, ["UNITY_EDITOR"]);

    private static IEnumerable<(string, TypeDeclarationSyntax)> Of(ProjectPackages packages, Func<PackageAssembly, bool> counts, string[] defines) =>
        from assembly in PackageAssembly.FindAll(packages).Where(counts)
        from tree in assembly.Parse([.. defines, .. assembly.ModuleDefines])
        from type in tree.GetRoot().DescendantNodes().OfType<TypeDeclarationSyntax>()
        select (Path.GetFileName(tree.FilePath), type);
}
