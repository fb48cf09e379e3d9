using System.Security.Cryptography;

namespace Headless.Checks.Documents.Facts;

/// <summary>
/// A line of images/pictures.csv: the picture, the scene, the command that played it, the moments that it shows [s], how many particles there were, the device and the day. The script that
/// makes a picture writes its line.
/// </summary>
internal sealed record PictureRecord(string Name, string File, string Sample, string Command, string[] Moments, string Particles, string Device, string Date, string Data, string Hash)
{
    public const string TableName = "pictures.csv";

    private const int HashLength = 12;

    /// <summary>Those of a folder of pictures.</summary>
    public static IReadOnlyList<PictureRecord> Read(string folder) => !System.IO.File.Exists(Path.Combine(folder, TableName)) ? [] :
        [.. CsvTable.Read(Path.Combine(folder, TableName)).Rows.Select(r => new PictureRecord(r["file"].Replace(".png", ""), Path.Combine(folder, r["file"]), r["sample"], r["command"],
            r["moments"].Split(' ', StringSplitOptions.RemoveEmptyEntries), r["particles"], r["device"], r["date"], r["data"], r["sha256"]))];

    /// <summary>Every folder of a project that has such a table.</summary>
    public static IEnumerable<string> Folders(ProjectPackages packages) =>
        packages.All.Select(p => Path.Combine(p, "Documentation~", "images")).Where(f => System.IO.File.Exists(Path.Combine(f, TableName)));

    /// <summary>0.8, 1.5 and 3 s</summary>
    public string Times => $"{FactText.List(Moments)} s";

    /// <summary>Whether the file is the picture that was recorded.</summary>
    public bool IsThisFile => System.IO.File.Exists(File) && Convert.ToHexString(SHA256.HashData(System.IO.File.ReadAllBytes(File)))[..HashLength].Equals(Hash, StringComparison.OrdinalIgnoreCase);
}
