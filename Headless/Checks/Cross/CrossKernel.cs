using Headless.Checks.Shaders;
using Headless.Shaders;
using System.Text.RegularExpressions;

namespace Headless.Checks.Cross;

/// <summary>A kernel variant in another shading language.</summary>
internal sealed partial class CrossKernel(ShaderVariant variant, ShaderBinary binary)
{
    private const string Front = "glslangValidator", Translator = "spirv-cross";

    public ShaderVariant Variant { get; } = variant;
    public int StorageBuffers { get; } = binary.Resources.Count(r => r.Kind is ResourceKind.StructuredBuffer or ResourceKind.RWStructuredBuffer
        or ResourceKind.ByteAddressBuffer or ResourceKind.RWByteAddressBuffer);
    public int Buffers => StorageBuffers + binary.Resources.Count(r => r.Kind == ResourceKind.ConstantBuffer);
    public int Threads { get; } = binary.GroupX * binary.GroupY * binary.GroupZ;
    public int SharedBytes { get; } = binary.SharedBytes;

    /// <summary>Translates into Metal's language; null, or what is wrong.</summary>
    public string? ToMetal(string folder)
    {
        var spirV = Write(folder, "metal.spv", binary.SpirV);
        var text = spirV + ".metal";
        return Problem(Tool.Run(Translator, spirV, "--msl", "--msl-version", "20100", "--output", text))
            // No compiler of Metal is at hand: the translator writes "double" where it should refuse.
            ?? (Doubles().IsMatch(File.ReadAllText(text)) ? "Metal has no numbers of 64 bits (double)" : null);
    }

    /// <summary>Translates into OpenGL ES 3.1's language and compiles that; null, or what is wrong.</summary>
    public string? ToEssl(string folder)
    {
        var problem = ToEssl(folder, binary.SpirV);
        // ESSL has no words for D3D's packing (a float3 of 12 bytes in an array); the code is the same in the layout of GLSL.
        return problem is not null && problem.Contains("std430", StringComparison.Ordinal) ? ToEssl(folder, Variant.CompileInGlslLayout(ShaderStage.Compute, Variant.Entry)) : problem;
    }

    private string? ToEssl(string folder, byte[] code)
    {
        var spirV = Write(folder, "essl.spv", code);
        var text = spirV + ".comp";
        return Problem(Tool.Run(Translator, spirV, "--es", "--version", "310", "--output", text))
            ?? Problem(Tool.Run(Front, "-S", "comp", text));
    }

    private string Write(string folder, string extension, byte[] bytes)
    {
        var path = Path.Combine(folder, $"{binary.Hash}.{extension}");
        File.WriteAllBytes(path, bytes);
        return path;
    }

    [GeneratedRegex(@"\bdouble[234]?\b")]
    private static partial Regex Doubles();

    private static string? Problem((int Code, string Output)? run) =>
        run is null ? "a program is missing" : run.Value.Code == 0 ? null : run.Value.Output.ReplaceLineEndings(" | ");
}
