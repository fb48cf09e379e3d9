using System.Text.RegularExpressions;
using Headless.Shaders.Preprocessing;

namespace Headless.Shaders;

/// <summary>Which macros differ from variant to variant of a source, and what the others are at its beginning.</summary>
/// <remarks>Names are read from all of its pragmas, those in branches of #if that are not taken included.</remarks>
internal sealed partial class VariantNames
{
    private readonly HashSet<string> _keywords = [];

    /// <summary>Those with other values than 1.</summary>
    private readonly HashSet<string> _others = [];

    private VariantNames()
    {
    }

    public static VariantNames Of(IEnumerable<SourceBlock> blocks, IncludeResolver includes)
    {
        VariantNames names = new();
        HashSet<string> read = [];
        Stack<SourceBlock> open = new(blocks);
        while (open.TryPop(out SourceBlock? block))
        {
            foreach (Match line in Line().Matches(block.Text))
            {
                string argument = CommentState.WithoutComments(line.Groups["argument"].Value).Trim();
                if (line.Groups["pragma"].Success)
                {
                    names.AddPragma(PragmaLine.Split(argument));
                }
                else if (SourceDirective.IncludedFile(argument) is { } file && includes.Resolve(file, block.Path) is { } found && read.Add(found))
                {
                    open.Push(new SourceBlock(found, includes.Read(found), 1));
                }
            }
        }
        return names;
    }

    /// <summary>What is known of a name before the source's first line.</summary>
    public IReadOnlyList<Macro> Initially(string name)
    {
        if (StageText.Constants.TryGetValue(name, out string? value)) return [Macro.Of(value)];
        if (_others.Contains(name) || StageText.Varies(name) || IsOfCompiler(name)) return [Macro.Somehow, Macro.Undefined];
        return _keywords.Contains(name) ? [Macro.Of("1"), Macro.Undefined] : [Macro.Undefined];
    }

    private void AddPragma(string[] words)
    {
        if (words.Length == 0) return;
        if (words[0] == "kernel") _others.UnionWith(words.Skip(2).Select(w => w.Split('=')[0]));
        else (KeywordPragmas.IsBranch(words) ? _others : _keywords).UnionWith(KeywordPragmas.Names(words));
    }

    private static bool IsOfCompiler(string name) =>
        name.StartsWith("__", StringComparison.Ordinal) || name.StartsWith("GL_", StringComparison.Ordinal) || name == "VULKAN";

    [GeneratedRegex(@"^[ \t]*#[ \t]*(?:(?<pragma>pragma)|include_with_pragmas)\b(?<argument>[^\r\n]*)", RegexOptions.Multiline)]
    private static partial Regex Line();
}
