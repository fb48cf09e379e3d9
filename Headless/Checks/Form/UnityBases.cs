using Microsoft.CodeAnalysis.CSharp.Syntax;

namespace Headless.Checks.Form;

/// <summary>Base classes that make a type one of scenes and assets.</summary>
internal static class UnityBases
{
    private static readonly string[] names = ["MonoBehaviour", "ScriptableObject", "PlayableAsset"];

    /// <summary>Whether a type names one of them as its base.</summary>
    public static bool HasUnityBase(this TypeDeclarationSyntax type) => type.BaseList?.Types.Any(b => names.Contains(b.Type.ToString())) ?? false;
}
