using System.Text;

namespace Headless.Shaders;

/// <summary>Puts include files in place and takes Unity's pragmas out, keeping files and lines for messages.</summary>
/// <remarks>
/// #if is left to the compiler, so includes of both branches are expanded; one that is not found becomes an #error, which
/// counts only where the branch is taken. "#pragma once" becomes an include guard.
/// </remarks>
internal sealed class IncludeExpander(IncludeResolver includes)
{
    private const int MaxDepth = 64;

    /// <summary>Characters with all includes in place; UnityCG.cginc and a package's files come to 300,000.</summary>
    private const int MaxLength = 16 << 20;
    private const int MaxIncludes = 10_000;

    private int _includes;

    private readonly StringBuilder _text = new();
    private readonly List<string> _files = [];
    private readonly List<string> _messages = [];
    private readonly List<PragmaLine> _pragmas = [];
    private readonly Stack<string> _open = new();

    public static ExpandedSource Expand(IncludeResolver includes, IEnumerable<SourceBlock> blocks)
    {
        IncludeExpander expander = new(includes);
        foreach (SourceBlock block in blocks)
        {
            expander.Add(block, withPragmas: true);
        }
        return new ExpandedSource(expander._text.ToString(), expander._files, expander._messages, expander._pragmas);
    }

    private void Add(SourceBlock block, bool withPragmas)
    {
        int file = FileNumber(block.Path);
        _open.Push(block.Path);
        bool guarded = HasPragmaOnce(block.Text);
        if (guarded)
        {
            _text.Append($"#ifndef HEADLESS_ONCE_{file}\n#define HEADLESS_ONCE_{file} 1\n");
        }
        _text.Append($"#line {block.FirstLine} {file}\n");
        string[] lines = block.Text.ReplaceLineEndings("\n").Split('\n');
        CommentState comments = new();
        for (int i = 0; i < lines.Length; i++)
        {
            bool inComment = comments.InBlock;
            comments.Advance(lines[i]);
            string trimmed = lines[i].TrimStart();
            int line = block.FirstLine + i;
            if (inComment || !trimmed.StartsWith('#') || !Directive(trimmed, block.Path, file, line, withPragmas))
            {
                _text.Append(lines[i]).Append('\n');
            }
        }
        if (guarded)
        {
            _text.Append("#endif\n");
        }
        _open.Pop();
    }

    /// <summary>True when the line was replaced.</summary>
    private bool Directive(string line, string path, int file, int number, bool withPragmas)
    {
        string body = line[1..].TrimStart();
        if (Keyword(body, "include_with_pragmas"))
        {
            Include(body["include_with_pragmas".Length..], path, file, number, withPragmas);
            return true;
        }
        if (Keyword(body, "include"))
        {
            Include(body["include".Length..], path, file, number, withPragmas: false);
            return true;
        }
        if (Keyword(body, "error"))
        {
            Error(body["error".Length..].Trim());
            return true;
        }
        if (!Keyword(body, "pragma"))
        {
            return false;
        }
        string[] words = CommentState.WithoutComments(body["pragma".Length..])
            .Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries);
        if (words.Length > 0 && words[0].StartsWith("pack_matrix", StringComparison.Ordinal))
        {
            return false;
        }
        if (withPragmas && words.Length > 0)
        {
            _pragmas.Add(new PragmaLine(includes.Shown(path), number, words));
        }
        _text.Append('\n');
        return true;
    }

    private void Include(string argument, string path, int file, int number, bool withPragmas)
    {
        string name = argument.Trim();
        int end = name.Length < 2 ? -1 : name[0] switch
        {
            '"' => name.IndexOf('"', 1),
            '<' => name.IndexOf('>', 1),
            _ => -1,
        };
        if (end < 0)
        {
            throw new ShaderCompileException(includes.Shown(path), number, "#include expects \"file\" or <file>");
        }
        string requested = name[1..end];
        if (includes.Resolve(requested, path) is not { } found)
        {
            Error($"Couldn't open include file '{requested}'.");
            return;
        }
        if (_open.Contains(found))
        {
            _text.Append('\n');
            return;
        }
        if (_open.Count >= MaxDepth)
        {
            throw new ShaderCompileException(includes.Shown(path), number, $"includes are nested more than {MaxDepth} deep");
        }
        if (++_includes > MaxIncludes || _text.Length > MaxLength)
        {
            throw new ShaderCompileException(
                includes.Shown(path), number, $"its includes come to more than {MaxIncludes} files or {MaxLength >> 20} million characters; guard them with #pragma once");
        }
        Add(new SourceBlock(found, includes.Read(found), 1), withPragmas);
        _text.Append($"#line {number + 1} {file}\n");
    }

    private void Error(string message)
    {
        _text.Append($"#error {ExpandedSource.MessageWord}{_messages.Count}\n");
        _messages.Add(message);
    }

    private int FileNumber(string path)
    {
        string shown = path.StartsWith(IncludeResolver.BuiltinFolder, StringComparison.Ordinal) ? path : includes.Shown(path);
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
        foreach (string line in text.Split('\n'))
        {
            string trimmed = line.TrimStart();
            if (trimmed.StartsWith('#') && Keyword(trimmed[1..].TrimStart(), "pragma")
                && trimmed[1..].TrimStart()["pragma".Length..].Trim().StartsWith("once", StringComparison.Ordinal))
            {
                return true;
            }
        }
        return false;
    }

    private static bool Keyword(string body, string word) =>
        body.StartsWith(word, StringComparison.Ordinal)
        && (body.Length == word.Length || !(char.IsLetterOrDigit(body[word.Length]) || body[word.Length] == '_'));
}
