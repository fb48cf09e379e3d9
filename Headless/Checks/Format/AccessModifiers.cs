using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;

namespace Headless.Checks.Format;

/// <summary>Declarations that leave out who may use them.</summary>
internal static class AccessModifiers
{
    public static bool AreOmitted(SyntaxNode node) => node is MemberDeclarationSyntax member && MayHave(member) && !member.Modifiers.Any(IsAccess);

    private static bool MayHave(MemberDeclarationSyntax member) =>
        member.Parent is ClassDeclarationSyntax or StructDeclarationSyntax or RecordDeclarationSyntax or BaseNamespaceDeclarationSyntax or CompilationUnitSyntax
        && member switch
        {
            ConstructorDeclarationSyntax constructor => !constructor.Modifiers.Any(SyntaxKind.StaticKeyword),
            MethodDeclarationSyntax method => method.ExplicitInterfaceSpecifier is null && !method.Modifiers.Any(SyntaxKind.PartialKeyword),
            BasePropertyDeclarationSyntax property => property.ExplicitInterfaceSpecifier is null && !property.Modifiers.Any(SyntaxKind.PartialKeyword),
            BaseTypeDeclarationSyntax or DelegateDeclarationSyntax or BaseFieldDeclarationSyntax => true,
            _ => false,
        };

    private static bool IsAccess(SyntaxToken modifier) =>
        modifier.Kind() is SyntaxKind.PublicKeyword or SyntaxKind.InternalKeyword or SyntaxKind.PrivateKeyword or SyntaxKind.ProtectedKeyword or SyntaxKind.FileKeyword;
}
