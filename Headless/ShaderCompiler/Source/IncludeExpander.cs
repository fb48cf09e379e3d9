using System.Text;
using Headless.Shaders.Preprocessing;

namespace Headless.Shaders;

/// <summary>Puts include files in place and takes Unity's pragmas out, keeping files and lines for messages.</summary>
/// <remarks>
/// Branches of #if that no variant takes become blank lines, and what they include is not looked for; the others are left to the
/// compiler. An include that is not found becomes an #error, which counts only where the branch is taken. "#pragma once" becomes
/// an include guard.
/// </remarks>
internal sealed class IncludeExpander
{
    private const int MaxDepth = 64;

    /// <summary>Characters with all includes in place; UnityCG.cginc and a package's files come to 300,000.</summary>
    private const int MaxLength = 16 << 20;
    private const int MaxIncludes = 10_000;

    private readonly IncludeResolver _includes;
    private readonly MacroTable _macros;
    private readonly Conditionals _conditionals;
    private readonly StringBuilder _text = new();
    private readonly List<string> _files = [];
    private readonly List<string> _messages = [];
    private readonly List<PragmaLine> _pragmas = [];
    private readonly Stack<string> _open = new();
    private readonly Dictionary<string, string> _read = [];
    private int _count;

    private IncludeExpander(IncludeResolver includes, VariantNames names)
    {
        _includes = includes;
        _macros = new MacroTable(names.Initially);
        _conditionals = new Conditionals(_macros);
    }

    public static ExpandedSource Expand(IncludeResolver includes, IReadOnlyList<SourceBlock> blocks)
    {
        IncludeExpander expander = new(includes, VariantNames.Of(blocks, includes));
        foreach (SourceBlock block in blocks)
        {
            expander.Add(block, withPragmas: true);
        }
        return new ExpandedSource(expander._text.ToString(), expander._files, expander._messages, expander._pragmas);
    }

    private void Add(SourceBlock block, bool withPragmas)
    {
        int file = FileNumber(block.Path);
        string guard = $"HEADLESS_ONCE_{file}";
        bool guarded = HasPragmaOnce(block.Text);
        if (guarded)
        {
            if (_macros.Only(guard) is { Defined: true })
            {
                return;
            }
            _conditionals.Take("ifndef", guard);
            Define($"{guard} 1");
            _text.Append($"#ifndef {guard}\n#define {guard} 1\n");
        }
        _open.Push(block.Path);
        _text.Append($"#line {block.FirstLine} {file}\n");
        string[] lines = block.Text.ReplaceLineEndings("\n").Split('\n');
        CommentState comments = new();
        for (int i = 0; i < lines.Length; i++)
        {
            int first = i;
            bool directive = !comments.InBlock && lines[i].AsSpan().TrimStart().StartsWith("#");
            comments.Advance(lines[i]);
            while (directive && lines[i].EndsWith('\\') && i + 1 < lines.Length)
            {
                comments.Advance(lines[++i]);
            }
            ReadOnlySpan<string> read = lines.AsSpan(first..(i + 1));
            if (!directive || !Directive(SourceDirective.Read(read), block.Path, file, block.FirstLine + first, withPragmas, read))
            {
                Append(read, _conditionals.Live);
            }
        }
        if (guarded)
        {
            _conditionals.Take("endif", "");
            _text.Append("#endif\n");
        }
        _open.Pop();
    }

    private void Append(ReadOnlySpan<string> lines, bool live)
    {
        foreach (string line in lines)
        {
            _text.Append(live ? line : "").Append('\n');
        }
    }

    /// <summary>True when the lines were put into the text, or what stands for them.</summary>
    private bool Directive(SourceDirective directive, string path, int file, int number, bool withPragmas, ReadOnlySpan<string> lines)
    {
        bool inLiveGroup = _conditionals.InLiveGroup;
        if (_conditionals.Take(directive.Word, directive.Argument))
        {
            if (_macros.Decisions.IsExhausted)
            {
                throw new ShaderCompileException(_includes.Shown(path), number, "its conditions and macros take too long to follow; divide the file");
            }
            Append(lines, directive.Word == "endif" ? inLiveGroup : _conditionals.InLiveGroup);
            return true;
        }
        if (!_conditionals.Live)
        {
            return false;
        }
        switch (directive.Word)
        {
            case "define":
                Define(directive.Argument);
                return false;
            case "undef":
                _macros.Set(directive.Argument, Macro.Undefined);
                return false;
            case "include_with_pragmas":
                Include(directive.Written, path, file, number, lines.Length, withPragmas);
                return true;
            case "include":
                Include(directive.Written, path, file, number, lines.Length, withPragmas: false);
                return true;
            case "error":
                Error(directive.Written, lines.Length);
                return true;
            case "pragma":
                return Pragma(directive.Argument, path, number, lines.Length, withPragmas);
            default:
                return false;
        }
    }

    private void Define(string definition)
    {
        if (Macro.Read(definition) is var (name, macro))
        {
            _macros.Set(name, macro);
        }
    }

    private bool Pragma(string argument, string path, int number, int lines, bool withPragmas)
    {
        string[] words = PragmaLine.Split(argument);
        if (words.Length > 0 && words[0].StartsWith("pack_matrix", StringComparison.Ordinal))
        {
            return false;
        }
        if (withPragmas && words.Length > 0)
        {
            _pragmas.Add(new PragmaLine(_includes.Shown(path), number, words));
        }
        _text.Append('\n', lines);
        return true;
    }

    private void Include(string argument, string path, int file, int number, int lines, bool withPragmas)
    {
        string requested = SourceDirective.IncludedFile(argument) ?? IncludedByMacro(argument)
            ?? throw new ShaderCompileException(_includes.Shown(path), number, "#include expects \"file\" or <file>");
        if (_includes.Resolve(requested, path) is not { } found)
        {
            Error($"Couldn't open include file '{requested}'.", lines);
            return;
        }
        if (_open.Contains(found))
        {
            _text.Append('\n', lines);
            return;
        }
        if (_open.Count >= MaxDepth)
        {
            throw new ShaderCompileException(_includes.Shown(path), number, $"includes are nested more than {MaxDepth} deep");
        }
        if (++_count > MaxIncludes || _text.Length > MaxLength)
        {
            throw new ShaderCompileException(
                _includes.Shown(path), number, $"its includes come to more than {MaxIncludes} files or {MaxLength >> 20} million characters; guard them with #pragma once");
        }
        if (!_read.TryGetValue(found, out string? text))
        {
            _read[found] = text = _includes.Read(found);
        }
        Add(new SourceBlock(found, text, 1), withPragmas);
        _text.Append($"#line {number + lines} {file}\n");
    }

    // #define HEADER "File.hlsl", then #include HEADER
    private string? IncludedByMacro(string name) => _macros.Only(name)?.Body is { Parameters: null } body ? SourceDirective.IncludedFile(body.Text) : null;

    private void Error(string message, int lines)
    {
        _text.Append($"#error {ExpandedSource.MessageWord}{_messages.Count}\n").Append('\n', lines - 1);
        _messages.Add(message);
    }

    private int FileNumber(string path)
    {
        string shown = path.StartsWith(IncludeResolver.BuiltinFolder, StringComparison.Ordinal) ? path : _includes.Shown(path);
        int index = _files.IndexOf(shown);
        if (index < 0)
        {
            _files.Add(shown);
            index = _files.Count - 1;
        }
        return index + 1;
    }

    private static bool HasPragmaOnce(string text)
    {
        foreach (ReadOnlySpan<char> line in text.AsSpan().EnumerateLines())
        {
            ReadOnlySpan<char> trimmed = line.TrimStart();
            if (trimmed.StartsWith("#") && trimmed[1..].TrimStart() is var body && body.StartsWith("pragma")
                && body["pragma".Length..].TrimStart().StartsWith("once"))
            {
                return true;
            }
        }
        return false;
    }
}
