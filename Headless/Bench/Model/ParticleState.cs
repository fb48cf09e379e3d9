using System.Globalization;
using System.Text;

namespace Headless.Bench.Model;

/// <summary>Positions of a binary PLY file of particles, as <c>./run play --state</c> writes it.</summary>
internal static class ParticleState
{
    /// <exception cref="UsageException">The file is no such PLY.</exception>
    public static (float X, float Y, float Z)[] Read(string file)
    {
        using var reader = new BinaryReader(File.OpenRead(file));
        int count = 0, stride = 0;
        var properties = new List<string>();
        for (string line = Line(reader); line != "end_header"; line = Line(reader))
        {
            string[] words = line.Split(' ');
            if (words is ["element", "vertex", var number]) count = int.Parse(number, CultureInfo.InvariantCulture);
            if (words is ["property", "float" or "uint" or "int", var name])
            {
                properties.Add(name);
                stride += sizeof(float);
            }
        }
        if (count == 0 || properties is not ["x", "y", "z", ..]) throw new UsageException($"--state: '{file}' has no particles with x, y and z.");
        var positions = new (float, float, float)[count];
        for (int i = 0; i < count; i++)
        {
            positions[i] = (reader.ReadSingle(), reader.ReadSingle(), reader.ReadSingle());
            reader.BaseStream.Seek(stride - 3 * sizeof(float), SeekOrigin.Current);
        }
        return positions;
    }

    private static string Line(BinaryReader reader)
    {
        const int longest = 1000;
        var line = new StringBuilder();
        for (char c = reader.ReadChar(); c != '\n' && line.Length < longest; c = reader.ReadChar()) line.Append(c);
        return line.ToString().TrimEnd('\r');
    }
}
