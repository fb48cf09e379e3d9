using System.Diagnostics.CodeAnalysis;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;

namespace Headless.Checks.Form;

/// <summary>
/// Without a domain reload statics outlive play mode: one that changes is assigned or emptied by a method that runs at SubsystemRegistration, or by what that
/// calls. [OutlivesPlay] says of another why it may stay. Of what is assigned once, collections count; what else is in it, PlayTwiceTests compares.
/// </summary>
internal sealed class StaticStateCheck
{
    private const string Stays = "OutlivesPlay";

    private readonly List<(string File, TypeDeclarationSyntax Type)> types;
    private readonly ILookup<string, TypeDeclarationSyntax> byName;
    private readonly HashSet<MethodDeclarationSyntax> reached = [];
    private readonly HashSet<(string Type, string Member)> assigned = [], called = [];

    public StaticStateCheck(ProjectPackages packages)
    {
        types = [.. PackageTypes.OfEditor(packages)];
        byName = types.ToLookup(t => t.Type.Identifier.Text, t => t.Type);
        foreach (var (_, type) in types)
            foreach (var hook in type.Members.OfType<MethodDeclarationSyntax>().Where(IsHook)) Follow(type.Identifier.Text, hook);
    }

    public CheckReport Run()
    {
        var report = new CheckReport("statics");
        var changing = 0;
        foreach (var (file, type) in types)
        {
            foreach (var (member, name) in type.Members.Where(m => m.Modifiers.Any(SyntaxKind.StaticKeyword)).SelectMany(Changing))
            {
                changing++;
                var isReset = (IsAssignedOnce(member) ? called : assigned).Contains((type.Identifier.Text, name));
                if (isReset == member.AttributeLists.Has(Stays))
                    report.Findings.Add($"{file}: the static {type.Identifier}.{name} " + (isReset
                        ? $"is reset when play begins, so [{Stays}] is wrong"
                        : $"changes and is not reset when play begins without a domain reload: reset it at SubsystemRegistration, or say by [{Stays}] why it may stay"));
            }
        }
        report.Figures = $"{changing} that change";
        return report;
    }

    private static bool IsHook(MethodDeclarationSyntax method) =>
        method.AttributeLists.Find("RuntimeInitializeOnLoadMethod")?.ArgumentList?.ToString().Contains("SubsystemRegistration", StringComparison.Ordinal) == true;

    private void Follow(string type, MethodDeclarationSyntax method)
    {
        if (!reached.Add(method)) return;
        foreach (var node in method.DescendantNodes())
        {
            if (node is AssignmentExpressionSyntax assignment)
                foreach (var target in assignment.Left is TupleExpressionSyntax tuple ? tuple.Arguments.Select(a => a.Expression) : [assignment.Left]) Note(assigned, type, target);
            if (node is not InvocationExpressionSyntax call) continue;
            switch (call.Expression)
            {
                case SimpleNameSyntax name: FollowAll(type, name); break;
                case MemberAccessExpressionSyntax { Name.Identifier.Text: "Clear" } member when member.Expression.ToString() is "Array" or "System.Array":
                    Note(assigned, type, call.ArgumentList.Arguments[0].Expression);
                    break;
                case MemberAccessExpressionSyntax { Expression: SimpleNameSyntax owner } member when byName.Contains(owner.Identifier.Text): FollowAll(owner.Identifier.Text, member.Name); break;
                case MemberAccessExpressionSyntax member: Note(called, type, member.Expression); break;
                default: break;
            }
        }
    }

    private void FollowAll(string type, SimpleNameSyntax name)
    {
        foreach (var method in byName[type].SelectMany(t => t.Members.OfType<MethodDeclarationSyntax>()).Where(m => m.Identifier.Text == name.Identifier.Text)) Follow(type, method);
    }

    /// <summary>A member of the type, or of another that is named before the dot.</summary>
    private static void Note(HashSet<(string, string)> found, string type, ExpressionSyntax target)
    {
        if (target is SimpleNameSyntax name) found.Add((type, name.Identifier.Text));
        if (target is MemberAccessExpressionSyntax { Expression: SimpleNameSyntax owner } member) found.Add((owner.Identifier.Text, member.Name.Identifier.Text));
    }

    private static IEnumerable<(MemberDeclarationSyntax Member, string Name)> Changing(MemberDeclarationSyntax member) =>
        !IsVariable(member, out var type, out var names) || (IsAssignedOnce(member) && !IsCollection(type)) ? [] : names.Select(n => (member, n));

    private static bool IsVariable(MemberDeclarationSyntax member, [NotNullWhen(true)] out TypeSyntax? type, out IEnumerable<string> names)
    {
        (type, names) = member switch
        {
            BaseFieldDeclarationSyntax field when !field.Modifiers.Any(SyntaxKind.ConstKeyword) => (field.Declaration.Type, field.Declaration.Variables.Select(v => v.Identifier.Text)),
            PropertyDeclarationSyntax property when property.AccessorList?.Accessors.All(a => a.Body is null && a.ExpressionBody is null) == true => (property.Type, [property.Identifier.Text]),
            _ => (null, (IEnumerable<string>)[]),
        };
        return type is not null;
    }

    private static bool IsAssignedOnce(MemberDeclarationSyntax member) => member switch
    {
        FieldDeclarationSyntax field => field.Modifiers.Any(SyntaxKind.ReadOnlyKeyword),
        PropertyDeclarationSyntax property => !property.AccessorList!.Accessors.Any(SyntaxKind.SetAccessorDeclaration),
        _ => false,
    };

    private static bool IsCollection(TypeSyntax type)
    {
        var name = ((type is QualifiedNameSyntax qualified ? qualified.Right : type) as GenericNameSyntax)?.Identifier.Text ?? type.ToString();
        return name is "List" or "Dictionary" or "HashSet" or "Queue" or "Stack" or "LinkedList" or "StringBuilder"
            || name.StartsWith("Sorted", StringComparison.Ordinal) || name.StartsWith("Concurrent", StringComparison.Ordinal);
    }
}
