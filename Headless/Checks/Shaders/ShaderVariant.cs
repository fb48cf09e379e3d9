using Headless.Shaders;
using Headless.Shaders.SpirV;

namespace Headless.Checks.Shaders;

/// <summary>A kernel, or a pass, with one choice of keywords.</summary>
/// <param name="File">As <see cref="ProjectPackages.NameOf"/> says.</param>
/// <param name="Entry">The kernel's name, or "SUBSHADER.PASS NAME" from 0.</param>
internal sealed record ShaderVariant(string File, string Entry, string Keywords, ShaderRequest Request)
{
    private const int ComputeTarget = 50;

    public bool IsKernel => Request.Source is not null;

    public string Name => $"{File} {Entry}{(Keywords.Length > 0 ? $" [{Keywords}]" : "")}";

    /// <summary>A kernel alone, or the stages of a pass in pipeline order.</summary>
    public IReadOnlyList<ShaderBinary> Compile(ShaderCompiler compiler) => Request.Source is { } source
        ? [compiler.CompileKernel(source, Request.Kernel!, Request.Keywords)]
        : compiler.CompilePass(Request.Pass!, Request.Keywords);

    /// <summary>A stage in GLSL's layout of memory, for languages that have no words for D3D's; neither linked nor kept.</summary>
    public byte[] CompileInGlslLayout(ShaderStage stage, string entry)
    {
        var job = Request.Pass is { } pass ? PassJob(pass, stage, entry) : KernelJob(Request.Source!);
        var module = new SpirVModule(new GlslangProcess("glslangValidator").Compile(job));
        SemanticNames.Strip(module);
        return module.ToBytes();
    }

    private StageJob PassJob(ShaderPass pass, ShaderStage stage, string entry) => new(pass.Program.Expanded, stage, entry,
        StageText.Build(pass.Program.Expanded, stage, pass.Program.Target, pass.Defines, Request.Keywords), Name);

    private StageJob KernelJob(ComputeSource source)
    {
        var defines = source.Kernels.First(k => k.Name == Request.Kernel).Defines;
        var (text, name) = KernelNames.Separate(StageText.Build(source.Expanded, ShaderStage.Compute, ComputeTarget, defines, Request.Keywords), Request.Kernel!);
        return new StageJob(source.Expanded, ShaderStage.Compute, Request.Kernel!, text, Name) { SourceEntryPoint = name };
    }
}
