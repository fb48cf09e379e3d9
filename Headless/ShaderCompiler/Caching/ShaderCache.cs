using System.Security.Cryptography;
using System.Text;

namespace Headless.Shaders;

/// <summary>Finished binaries on disk, one file a kernel or pass variant, named by the hash of its whole source text.</summary>
internal sealed class ShaderCache(string directory)
{
    /// <summary>Raised whenever rewriting or the file format changes.</summary>
    private const int FormatVersion = 8;

    /// <summary>Why the last write failed; null when none did.</summary>
    public string? WriteProblem { get; private set; }

    /// <param name="compiler">Sets the files of another compiler than glslang apart.</param>
    public static string Key(IEnumerable<StageJob> jobs, string compiler = "")
    {
        using IncrementalHash hash = IncrementalHash.CreateHash(HashAlgorithmName.SHA256);
        hash.AppendData(Encoding.UTF8.GetBytes(compiler));
        foreach (StageJob job in jobs)
        {
            hash.AppendData(Encoding.UTF8.GetBytes($"{FormatVersion}\0{job.Stage}\0{job.EntryPoint}\0{WaveOperations.Allowed(job)}\0{job.Text}\0"));
        }
        return Convert.ToHexStringLower(hash.GetHashAndReset());
    }

    /// <param name="compilerVersion">Version of the compiler at hand; null accepts any.</param>
    public IReadOnlyList<ShaderBinary>? Read(string key, string? compilerVersion)
    {
        string path = FilePath(key);
        if (!File.Exists(path))
        {
            return null;
        }
        try
        {
            using BinaryReader reader = new(new MemoryStream(File.ReadAllBytes(path)));
            string made = reader.ReadString();
            return compilerVersion is null || made == compilerVersion ? ShaderBinaryFormat.Read(reader) : null;
        }
        catch (Exception e) when (e is IOException or InvalidDataException or FormatException)
        {
            return null;
        }
    }

    public void Write(string key, string compilerVersion, IReadOnlyList<ShaderBinary> binaries)
    {
        string temporary = FilePath(key) + "." + Guid.NewGuid().ToString("N");
        try
        {
            Directory.CreateDirectory(Path.GetDirectoryName(FilePath(key))!);
            using (BinaryWriter writer = new(File.Create(temporary)))
            {
                writer.Write(compilerVersion);
                ShaderBinaryFormat.Write(writer, binaries);
            }
            File.Move(temporary, FilePath(key), overwrite: true);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            WriteProblem = $"shader cache '{directory}' cannot be written: {e.Message}";
            if (File.Exists(temporary)) File.Delete(temporary);
        }
    }

    private string FilePath(string key) => Path.Combine(directory, key[..2], key + ".shader");
}
