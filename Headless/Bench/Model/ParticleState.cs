using System.Globalization;
using System.Text;

namespace Headless.Bench.Model;

/// <summary>Positions of a binary PLY file of particles, as <c>./run play --state</c> writes it: doubles, or floats of an earlier version.</summary>
internal static class ParticleState
{
    /// <exception cref="UsageException">The file is no such PLY.</exception>
    public static (float X, float Y, float Z)[] Read(string file)
    {
        using var reader = new BinaryReader(File.OpenRead(file));
        int count = 0, stride = 0, size = 0;
        var properties = new List<string>();
        for (string line = Line(reader); line != "end_header"; line = Line(reader))
        {
            string[] words = line.Split(' ');
            if (words is ["element", "vertex", var number]) count = int.Parse(number, CultureInfo.InvariantCulture);
            if (words is not ["property", "float" or "uint" or "int" or "double", var name]) continue;
            int own = words[1] == "double" ? sizeof(double) : sizeof(float);
            if (properties.Count == 0) size = own;
            if (properties.Count < 3 && size != own) throw new UsageException($"--state: '{file}' has x, y and z of different types.");
            properties.Add(name);
            stride += own;
        }
        if (count == 0 || properties is not ["x", "y", "z", ..]) throw new UsageException($"--state: '{file}' has no particles with x, y and z.");
        var positions = new (float, float, float)[count];
        for (int i = 0; i < count; i++)
        {
            positions[i] = (Number(), Number(), Number());
            reader.BaseStream.Seek(stride - 3 * size, SeekOrigin.Current);
        }
        return positions;

        float Number() => size == sizeof(double) ? (float)reader.ReadDouble() : reader.ReadSingle();
    }

    private static string Line(BinaryReader reader)
    {
        const int longest = 1000;
        var line = new StringBuilder();
        for (char c = reader.ReadChar(); c != '\n' && line.Length < longest; c = reader.ReadChar()) line.Append(c);
        return line.ToString().TrimEnd('\r');
    }
}
