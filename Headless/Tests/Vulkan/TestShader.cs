using NUnit.Framework;
using System.Diagnostics;
using System.Security.Cryptography;
using Headless.Shaders;

namespace Headless.Tests.Vulkan;

/// <summary>Small HLSL shaders with bindings written out, so that these tests need nothing of the shader compiler.</summary>
internal static class TestShader
{
    private static readonly Dictionary<string, ShaderBinary> Compiled = [];

    public static ShaderResource Uniform(int binding, int size, string name = "Constants") =>
        new(name, ResourceKind.ConstantBuffer, binding, size, 0, [], "");

    public static ShaderResource Read(int binding, string name) => new(name, ResourceKind.StructuredBuffer, binding, 0, 4, [], "");

    public static ShaderResource Write(int binding, string name) => new(name, ResourceKind.RWStructuredBuffer, binding, 0, 4, [], "");

    public static ShaderResource Texture(int binding, string name, string dimension = "2D") =>
        new(name, ResourceKind.Texture, binding, 0, 0, [], dimension);

    public static ShaderResource Image(int binding, string name, ImageFormat format, string dimension = "2D") =>
        new(name, ResourceKind.RWTexture, binding, 0, 0, [], dimension) { Format = format, SampledType = "float" };

    public static ShaderResource Sampler(int binding, string name) => new(name, ResourceKind.Sampler, binding, 0, 0, [], "");

    public static ShaderBinary Kernel(string entry, int groupX, string hlsl, params ShaderResource[] resources) =>
        Get(ShaderStage.Compute, entry, hlsl, resources, [], groupX);

    public static ShaderBinary Stage(ShaderStage stage, string entry, string hlsl, params ShaderResource[] resources) =>
        Get(stage, entry, hlsl, resources, [], 0);

    public static ShaderBinary Vertex(string entry, string hlsl, VertexInput[] inputs, params ShaderResource[] resources) =>
        Get(ShaderStage.Vertex, entry, hlsl, resources, inputs, 0);

    private static ShaderBinary Get(ShaderStage stage, string entry, string hlsl, ShaderResource[] resources, VertexInput[] inputs, int groupX)
    {
        string key = $"{stage} {entry}\n{hlsl}";
        if (!Compiled.TryGetValue(key, out ShaderBinary? binary))
        {
            byte[] code = Compile(stage, entry, hlsl);
            string hash = Convert.ToHexStringLower(SHA256.HashData(code));
            Compiled[key] = binary = new ShaderBinary(stage, entry, code, resources, inputs, groupX, 1, 1, 0, hash);
        }

        return binary;
    }

    private static byte[] Compile(ShaderStage stage, string entry, string hlsl)
    {
        string folder = Directory.CreateTempSubdirectory("vulkan-test").FullName;
        try
        {
            string source = Path.Combine(folder, "shader.hlsl");
            string target = Path.Combine(folder, "shader.spv");
            File.WriteAllText(source, hlsl);
            string name = stage switch { ShaderStage.Vertex => "vert", ShaderStage.Geometry => "geom", ShaderStage.Fragment => "frag", _ => "comp" };
            string[] arguments = ["-D", "-V", "--target-env", "vulkan1.1", "--hlsl-offsets", "-S", name, "-e", entry, "-o", target, source];
            ProcessStartInfo start = new("glslangValidator", arguments) { RedirectStandardOutput = true, RedirectStandardError = true };
            using Process process = Process.Start(start)!;
            string output = process.StandardOutput.ReadToEnd() + process.StandardError.ReadToEnd();
            process.WaitForExit();
            Assert.That(process.ExitCode, Is.Zero, output);
            return File.ReadAllBytes(target);
        }
        finally
        {
            Directory.Delete(folder, recursive: true);
        }
    }
}
