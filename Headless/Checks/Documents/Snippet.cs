using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;
using System.Text.RegularExpressions;

namespace Headless.Checks.Documents;

/// <summary>
/// A piece of C# of a document, made a file that can be compiled: a file stays as it is, members get a class about them, statements a
/// method. What the page takes for granted is stated in a comment before the fence, which readers do not see:
/// <c>&lt;!-- given: Text label; Rigidbody crate; --&gt;</c>. Code for packages that are not Unity's own is left out with its reason:
/// <c>&lt;!-- not compiled: needs the Visual Effect Graph --&gt;</c>.
/// </summary>
internal sealed partial class Snippet(MarkdownFile document, Fence fence)
{
    private const string Usings =
        "using System; using System.Collections; using System.Collections.Generic; using System.IO; using NUnit.Framework; using SphFluid; using UnityEngine; "
        + "using UnityEngine.Events; using UnityEngine.Rendering; using Object = UnityEngine.Object; using Random = UnityEngine.Random;\n";

    /// <summary>What stands for the reader's own objects in every snippet.</summary>
    public const string Scene = """
        using SphFluid;
        class SnippetScene : UnityEngine.MonoBehaviour
        {
            protected FluidSimulation simulation;
            protected FluidEmitter emitter;
            protected FluidDrain drain;
            protected FluidForceZone zone;
            protected FluidSensor sensor;
        }
        """;

    public static IEnumerable<Snippet> Of(MarkdownFile document) => document.Fences().Where(f => f.Language is "csharp" or "cs" or "c#").Select(f => new Snippet(document, f));

    public string Place => $"{document.Shown}({fence.Line})";

    /// <summary>Why it is not compiled, else null.</summary>
    public string? NotCompiled => Excuse().Match(fence.Comments) is { Success: true } excuse ? excuse.Groups[1].Value.Trim() : null;

    /// <summary>All words of it, and of what it takes for granted.</summary>
    public string Text => Usings + Scene + fence.Comments + fence.Text;

    public SyntaxTree Parse(CSharpParseOptions options) => CSharpSyntaxTree.ParseText(Whole(options), options, document.Shown);

    private string Whole(CSharpParseOptions options)
    {
        var code = $"#line {fence.Line} \"{document.Shown}\"\n{fence.Text}\n#line hidden\n";
        var given = string.Concat(Given().Matches(fence.Comments).Select(m => m.Groups[1].Value.ReplaceLineEndings(" ")));
        var unit = (CompilationUnitSyntax)CSharpSyntaxTree.ParseText(fence.Text, options).GetRoot();
        var statements = unit.Members.OfType<GlobalStatementSyntax>().Select(g => g.Statement).ToList();
        if (statements.Count == 0 && !unit.GetDiagnostics().Any(d => d.Severity == DiagnosticSeverity.Error))
            return (unit.Usings.Count > 0 ? "" : Usings) + code;
        var members = statements.All(s => s is LocalFunctionStatementSyntax or LocalDeclarationStatementSyntax) && statements.Exists(s => s is LocalFunctionStatementSyntax);
        var result = unit.DescendantNodes().OfType<YieldStatementSyntax>().Any() ? "IEnumerator" : "void";
        var laboratory = document.Shown.Contains("validation", StringComparison.Ordinal) ? "using SphFluid.Validation; " : "";
        return $"{laboratory}{Usings}class Snippet : SnippetScene {{ {given}\n{(members ? code : $"{result} Run() {{\n{code}}}")}}}";
    }

    [GeneratedRegex(@"<!-- *given:([\s\S]*?)-->")] private static partial Regex Given();
    [GeneratedRegex(@"<!-- *not compiled:([\s\S]*?)-->")] private static partial Regex Excuse();
}
