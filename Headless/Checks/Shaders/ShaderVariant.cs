using Headless.Shaders;

namespace Headless.Checks.Shaders;

/// <summary>A kernel, or a pass, with one choice of keywords.</summary>
/// <param name="File">As <see cref="ProjectPackages.NameOf"/> says.</param>
/// <param name="Entry">The kernel's name, or "SUBSHADER.PASS NAME" from 0.</param>
internal sealed record ShaderVariant(string File, string Entry, string Keywords, ShaderRequest Request)
{
    public bool IsKernel => Request.Source is not null;

    public string Name => $"{File} {Entry}{(Keywords.Length > 0 ? $" [{Keywords}]" : "")}";

    /// <summary>A kernel alone, or the stages of a pass in pipeline order.</summary>
    public IReadOnlyList<ShaderBinary> Compile(ShaderCompiler compiler) => Request.Source is { } source
        ? [compiler.CompileKernel(source, Request.Kernel!, Request.Keywords)]
        : compiler.CompilePass(Request.Pass!, Request.Keywords);
}
