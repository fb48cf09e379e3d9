using System;
using System.IO;
using System.Text;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Reads what PlyWriter.WriteMesh wrote.</summary>
    internal static class PlyMesh
    {
        public static SurfaceMesh Read(string file)
        {
            byte[] bytes = File.ReadAllBytes(file);
            string text = Encoding.ASCII.GetString(bytes);
            const string end = "end_header\n";
            int at = text.IndexOf(end, StringComparison.Ordinal) + end.Length;
            var positions = new Vector3[Count(text, "vertex")];
            var normals = new Vector3[positions.Length];
            var indices = new int[3 * Count(text, "face")];
            using (var reader = new BinaryReader(new MemoryStream(bytes, at, bytes.Length - at)))
            {
                for (int i = 0; i < positions.Length; i++)
                {
                    positions[i] = new Vector3((float)reader.ReadDouble(), (float)reader.ReadDouble(), (float)reader.ReadDouble());
                    normals[i] = new Vector3(reader.ReadSingle(), reader.ReadSingle(), reader.ReadSingle());
                }
                for (int i = 0; i < indices.Length; i++)
                {
                    if (i % 3 == 0 && reader.ReadByte() != 3) throw new InvalidDataException($"'{file}' has a face that is no triangle.");
                    indices[i] = reader.ReadInt32();
                }
            }
            return new SurfaceMesh(positions, normals, indices);
        }

        private static int Count(string header, string element)
        {
            string line = $"element {element} ";
            int from = header.IndexOf(line, StringComparison.Ordinal) + line.Length;
            return int.Parse(header.Substring(from, header.IndexOf('\n', from) - from));
        }
    }
}
