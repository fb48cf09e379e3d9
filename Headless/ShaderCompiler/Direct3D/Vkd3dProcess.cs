using System.Diagnostics;

namespace Headless.Shaders.Direct3D;

/// <summary>Runs vkd3d-compiler, which translates Direct3D's compiled shaders to SPIR-V.</summary>
internal sealed class Vkd3dProcess(string program)
{
    // Of the modifier that names a raw or structured buffer and its mixed contents ("ld_structured_indexable(structured_buffer, stride=4)
    // (mixed,mixed,mixed,mixed)"): the translation of these instructions does not need it.
    private static readonly string[] Harmless = ["Unhandled resource type 0xb.", "Unhandled resource type 0xc.", "Unhandled data type 0x6."];

    private readonly Lazy<string?> _version = new(() => ProgramVersion.Read(program));

    /// <summary>Version text, or null when the program is not there.</summary>
    public string? Version => _version.Value;

    /// <exception cref="InvalidDataException">The shader holds something that vkd3d-compiler cannot translate.</exception>
    public byte[] Translate(byte[] shader)
    {
        ProcessStartInfo start = new(program, ["-x", "dxbc-tpf", "-b", "spirv-binary", "--buffer-uav=storage-buffer", "-o", "-", "-"])
        {
            RedirectStandardInput = true,
            RedirectStandardOutput = true,
            RedirectStandardError = true,
        };
        // It leaves out an instruction that it does not know and says so at this level only.
        start.Environment["VKD3D_SHADER_DEBUG"] = "fixme";
        using Process process = Process.Start(start)!;
        using MemoryStream output = new();
        Task read = process.StandardOutput.BaseStream.CopyToAsync(output);
        Task<string> errors = process.StandardError.ReadToEndAsync();
        try
        {
            process.StandardInput.BaseStream.Write(shader);
            process.StandardInput.Close();
        }
        catch (IOException)
        {
            // The process ended before it read everything: its exit code tells why.
        }
        process.WaitForExit();
        read.Wait();
        string messages = string.Join("; ", errors.Result.Split('\n', StringSplitOptions.TrimEntries)
            .Where(m => m.Length > 0 && !Harmless.Any(h => m.EndsWith(h, StringComparison.Ordinal))).Distinct());
        return process.ExitCode == 0 && messages.Length == 0
            ? output.ToArray()
            : throw new InvalidDataException($"vkd3d-compiler: {(messages.Length > 0 ? messages : "exit code " + process.ExitCode)}");
    }
}
