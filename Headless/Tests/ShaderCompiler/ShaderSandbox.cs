using System.ComponentModel;
using System.Diagnostics;
using Headless.Shaders;
using NUnit.Framework;

namespace Headless.Tests.Shaders;

/// <summary>A project folder of its own with shader files, and a compiler with an empty cache.</summary>
internal sealed class ShaderSandbox : IDisposable
{
    private readonly string folder = Path.Combine(Path.GetTempPath(), "shader-tests-" + Guid.NewGuid().ToString("N"));

    public ShaderSandbox()
    {
        Directory.CreateDirectory(Path.Combine(folder, "Assets"));
    }

    public string Root => folder;

    public string Cache => Path.Combine(folder, "cache");

    public IncludeResolver Includes => new(folder);

    public string Add(string path, string text)
    {
        string full = Path.Combine(folder, path);
        Directory.CreateDirectory(Path.GetDirectoryName(full)!);
        File.WriteAllText(full, text);
        return full;
    }

    /// <summary>Compiles the kernels where it is set; otherwise glslang does.</summary>
    public Direct3DFrontEnd? Direct3D { get; init; }

    public ShaderCompiler Compiler(string program = "glslangValidator") => new(Cache, Includes, program) { Direct3D = Direct3D };

    /// <summary>Compiles kernel CS of a compute source and validates it.</summary>
    public ShaderBinary Kernel(string source, params string[] keywords)
    {
        string path = Add("Assets/Test.compute", "#pragma kernel CS\n" + source);
        ShaderBinary binary = Compiler().CompileKernel(ComputeSource.Parse(path, Includes), "CS", keywords);
        Validate(binary);
        return binary;
    }

    /// <summary>Compiles the only pass of a shader whose HLSL is given, and validates the stages.</summary>
    public IReadOnlyList<ShaderBinary> Pass(string hlsl, params string[] keywords)
    {
        string text = "Shader \"Test\" { SubShader { Pass { HLSLPROGRAM\n" + hlsl + "\nENDHLSL } } }";
        ShaderLabSource source = ShaderLabSource.Parse(Add("Assets/Test.shader", text), Includes);
        IReadOnlyList<ShaderBinary> stages = Compiler().CompilePass(source.SubShaders[0].Passes[0], keywords);
        foreach (ShaderBinary stage in stages)
        {
            Validate(stage);
        }
        return stages;
    }

    public static void Validate(ShaderBinary binary)
    {
        string file = Path.Combine(Path.GetTempPath(), Guid.NewGuid().ToString("N") + ".spv");
        File.WriteAllBytes(file, binary.SpirV);
        try
        {
            ProcessStartInfo start = new("spirv-val", ["--target-env", "vulkan1.3", "--scalar-block-layout", file])
            {
                RedirectStandardError = true,
            };
            using Process process = Process.Start(start)!;
            string errors = process.StandardError.ReadToEnd();
            process.WaitForExit();
            Assert.That(process.ExitCode, Is.Zero, $"{binary.Stage} {binary.EntryPoint}: {errors}");
        }
        catch (Win32Exception)
        {
            Assert.Ignore("spirv-val is not installed (package spirv-tools)");
        }
        finally
        {
            File.Delete(file);
        }
    }

    public void Dispose() => Directory.Delete(folder, recursive: true);
}
