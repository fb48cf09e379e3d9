namespace Headless.Shaders;

/// <summary>Something for <see cref="ShaderCompiler.Prewarm"/>: a kernel of a compute file, or a pass.</summary>
public sealed record ShaderRequest
{
    public ShaderRequest(ComputeSource source, string kernel, IReadOnlyCollection<string> keywords)
    {
        Source = source;
        Kernel = kernel;
        Keywords = keywords;
    }

    public ShaderRequest(ShaderPass pass, IReadOnlyCollection<string> keywords)
    {
        Pass = pass;
        Keywords = keywords;
    }

    public ComputeSource? Source { get; }
    public string? Kernel { get; }
    public ShaderPass? Pass { get; }
    public IReadOnlyCollection<string> Keywords { get; }
}
