namespace Headless.Shaders;

/// <summary>A .compute file: its kernels and keywords.</summary>
public sealed class ComputeSource
{
    /// <summary>Path for messages, relative to the project where it lies in it.</summary>
    public string Path { get; }
    public IReadOnlyList<KernelDeclaration> Kernels { get; }
    public IReadOnlyList<KeywordSet> KeywordSets { get; }

    /// <summary>Words of "#pragma require".</summary>
    public IReadOnlyList<string> Requires { get; }

    internal ExpandedSource Expanded { get; }

    private ComputeSource(string path, ExpandedSource expanded)
    {
        Path = path;
        Expanded = expanded;
        List<KernelDeclaration> kernels = [];
        List<KeywordSet> sets = [];
        List<string> requires = [];
        foreach (PragmaLine pragma in expanded.Pragmas)
        {
            switch (pragma.Words[0])
            {
                case "kernel":
                    kernels.Add(Kernel(pragma));
                    break;
                case "require":
                    requires.AddRange(pragma.Words.Skip(1));
                    break;
                default:
                    sets.AddRange(KeywordPragmas.Read(pragma) ?? []);
                    break;
            }
        }
        if (kernels.Count == 0)
        {
            throw new ShaderCompileException(path, 0, "no kernel: add a line \"#pragma kernel Name\"");
        }
        Kernels = kernels;
        KeywordSets = sets;
        Requires = requires;
    }

    /// <summary>Whether both are the same text with the same includes.</summary>
    public bool HasSameText(ComputeSource other) => Expanded.Text == other.Expanded.Text;

    /// <exception cref="ShaderCompileException">No kernel, or a pragma that cannot be read.</exception>
    public static ComputeSource Parse(string path, IncludeResolver includes) =>
        ParseText(System.IO.Path.GetFullPath(path), includes.Read(path), includes);

    /// <summary>Parses text that is not on disk; <paramref name="path"/> places it for relative includes and messages.</summary>
    public static ComputeSource ParseText(string path, string text, IncludeResolver includes)
    {
        ExpandedSource expanded = IncludeExpander.Expand(includes, [new SourceBlock(path, text, 1)]);
        return new ComputeSource(includes.Shown(path), expanded);
    }

    private static KernelDeclaration Kernel(PragmaLine pragma)
    {
        if (pragma.Words.Count < 2)
        {
            throw new ShaderCompileException(pragma.File, pragma.Line, "#pragma kernel needs a name");
        }
        List<KeyValuePair<string, string>> defines = [];
        foreach (string word in pragma.Words.Skip(2))
        {
            string[] parts = word.Split('=', 2);
            defines.Add(KeyValuePair.Create(parts[0], parts.Length == 2 ? parts[1] : "1"));
        }
        return new KernelDeclaration(pragma.Words[1].TrimEnd(';'), defines, pragma.Line);
    }
}
