using System.Collections.Concurrent;
using Headless.Shaders.Direct3D;

namespace Headless.Shaders;

/// <summary>
/// Compiles kernels with Microsoft's FXC, the compiler that Unity uses for Direct3D 11, and translates its code to SPIR-V with
/// vkd3d-compiler, so that a Vulkan device runs what Direct3D would. Safe for several threads.
/// </summary>
public sealed class Direct3DFrontEnd : IDisposable
{
    /// <summary>Raised whenever the rewriting changes.</summary>
    private const int FormatVersion = 2;

    private readonly WineToolchain _toolchain;
    private readonly FxcCompiler _compiler;
    private readonly Vkd3dProcess _translator;
    private readonly Lazy<string> _version;
    private readonly ConcurrentDictionary<string, string> _untranslated = [];

    /// <param name="cacheFolder">Where setup.sh puts d3dcompiler_47.dll.</param>
    /// <param name="translator">Name or path of vkd3d-compiler.</param>
    public Direct3DFrontEnd(string cacheFolder, string translator = "vkd3d-compiler")
    {
        _toolchain = new WineToolchain(WineDriver.Fxc, cacheFolder);
        _compiler = new FxcCompiler(_toolchain);
        _translator = new Vkd3dProcess(translator);
        _version = new Lazy<string>(() => $"d3dcompiler_47 {_toolchain.Version()}, {_translator.Version}, {FormatVersion}");
    }

    /// <summary>What is missing on this machine and how to get it; null when all is there. The first call sets Wine up.</summary>
    public string? Missing => _compiler.Problem
        ?? (_translator.Version is null ? "vkd3d-compiler is not installed: apt-get install vkd3d-compiler" : null);

    /// <summary>Names what the binaries are made with.</summary>
    public string Version => _version.Value;

    /// <summary>Kernels that could not be translated, by what is compiled, with the reason. Another compiler made these.</summary>
    public IReadOnlyDictionary<string, string> Untranslated => _untranslated;

    public void Dispose() => _compiler.Dispose();

    /// <summary>The binary, or null for a kernel that cannot be translated, which is then listed.</summary>
    /// <exception cref="ShaderCompileException">An error in the source.</exception>
    internal ShaderBinary? Compile(StageJob job)
    {
        byte[] shader = _compiler.Compile(job);
        try
        {
            return Direct3DBinary.Build(job, shader, _translator.Translate(shader));
        }
        catch (InvalidDataException e)
        {
            _untranslated[$"{job.Owner} of '{job.Source.Files[0]}'"] = e.Message;
            return null;
        }
    }
}
