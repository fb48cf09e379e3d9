using Microsoft.CodeAnalysis;

namespace Headless.Checks.Api;

/// <summary>Membership in one Unity line's lists, inherited members included.</summary>
internal sealed class ListedApi
{
    private readonly HashSet<string> ids;
    public UnityLine Line { get; }

    public ListedApi(ApiList list)
    {
        Line = list.Line;
        ids = list.All.Concat(list.OfPackagesInEditor).Select(e => e.DocumentationId).ToHashSet();
    }

    public bool Contains(ISymbol symbol, INamedTypeSymbol type)
    {
        var id = symbol.GetDocumentationCommentId();
        if (id is null || ids.Contains(id)) return true;
        if (symbol is INamedTypeSymbol) return false;
        // An override here may be declared only by a base class there (for example ToString).
        for (var overridden = Overridden(symbol); overridden is not null; overridden = Overridden(overridden))
            if (overridden.ContainingAssembly.Name.StartsWith("System", StringComparison.Ordinal) || ids.Contains(overridden.GetDocumentationCommentId() ?? "")) return true;
        var ownId = $".{type.ToDisplayString().Split('<')[0]}.";
        for (var b = type.BaseType; b is not null; b = b.BaseType)
            if (ids.Contains(id.Replace(ownId.Trim('.') + ".", b.ToDisplayString().Split('<')[0] + "."))) return true;
        return false;
    }

    private static ISymbol? Overridden(ISymbol symbol) => symbol switch
    {
        IMethodSymbol m => m.OverriddenMethod,
        IPropertySymbol p => p.OverriddenProperty,
        IEventSymbol e => e.OverriddenEvent,
        _ => null,
    };
}
