using Headless.Checks.Api;
using Microsoft.CodeAnalysis.CSharp.Syntax;

namespace Headless.Checks.Form;

/// <summary>Types of the package's assemblies as they are written, each with the name of its file.</summary>
internal static class PackageTypes
{
    /// <summary>What a player has of the package.</summary>
    public static IEnumerable<(string File, TypeDeclarationSyntax Type)> OfPlayers(string packageRoot) =>
        Of(packageRoot, a => !a.IsTest && !a.EditorOnly, []);

    /// <summary>What the Editor has of the package, without its tests.</summary>
    public static IEnumerable<(string File, TypeDeclarationSyntax Type)> OfEditor(string packageRoot) =>
        Of(packageRoot, a => !a.IsTest, ["UNITY_EDITOR"]);

    private static IEnumerable<(string, TypeDeclarationSyntax)> Of(string packageRoot, Func<PackageAssembly, bool> counts, string[] defines) =>
        from assembly in PackageAssembly.FindAll(packageRoot).Where(counts)
        from tree in assembly.Parse(defines)
        from type in tree.GetRoot().DescendantNodes().OfType<TypeDeclarationSyntax>()
        select (Path.GetFileName(tree.FilePath), type);
}
