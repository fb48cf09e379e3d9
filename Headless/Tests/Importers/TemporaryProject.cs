using System.Security.Cryptography;
using System.Text;

namespace Headless.Tests.Importers;

/// <summary>A Unity project in a temporary folder; <see cref="Add"/> writes a file with its .meta.</summary>
public sealed class TemporaryProject : IDisposable
{
    public TemporaryProject()
    {
        Root = Directory.CreateTempSubdirectory("unity-project-").FullName;
        Directory.CreateDirectory(Path.Combine(Root, "Assets"));
    }

    public string Root { get; }

    public static string Guid(string path) => Convert.ToHexStringLower(MD5.HashData(Encoding.UTF8.GetBytes(path)));

    public string Add(string path, string text, string settings = "DefaultImporter:\n  userData: \n", string? guid = null)
    {
        string file = Path.Combine(Root, path);
        Directory.CreateDirectory(Path.GetDirectoryName(file)!);
        File.WriteAllText(file, text);
        File.WriteAllText(file + ".meta", $"fileFormatVersion: 2\nguid: {guid ?? Guid(path)}\n{settings}");
        return guid ?? Guid(path);
    }

    public void Dispose() => Directory.Delete(Root, recursive: true);
}
