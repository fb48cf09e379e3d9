using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp.Syntax;

namespace Headless.Checks.Form;

/// <summary>Attributes by name, as they are written.</summary>
internal static class SyntaxAttributes
{
    public static bool Has(this SyntaxList<AttributeListSyntax> lists, string name) => lists.Find(name) is not null;

    public static AttributeSyntax? Find(this SyntaxList<AttributeListSyntax> lists, string name) =>
        lists.SelectMany(l => l.Attributes).FirstOrDefault(a => a.Name.ToString().Split('.')[^1] is var n && (n == name || n == name + "Attribute"));
}
