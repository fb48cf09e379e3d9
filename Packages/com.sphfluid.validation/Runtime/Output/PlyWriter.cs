using System;
using System.IO;
using System.Text;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Writes particles and surfaces as binary little-endian PLY, in world space and SI units.</summary>
    public static class PlyWriter
    {
        /// <summary>
        /// Writes one vertex a particle, in the order of their ids: x y z [m], vx vy vz [m/s], density [kg/m³],
        /// pressure [Pa] as float, id as uint.
        /// </summary>
        /// <exception cref="IOException">The file cannot be written.</exception>
        public static void WriteParticles(string file, FluidSnapshot snapshot)
        {
            string[] properties = { "float x", "float y", "float z", "float vx", "float vy", "float vz", "float density", "float pressure", "uint id" };
            using (BinaryWriter writer = Open(file, Element("vertex", snapshot.Count, properties)))
            {
                for (int i = 0; i < snapshot.Count; i++)
                {
                    Write(writer, snapshot.Positions[i]);
                    Write(writer, snapshot.Velocities[i]);
                    writer.Write(snapshot.Densities[i]);
                    writer.Write(snapshot.Pressures[i]);
                    writer.Write(snapshot.Ids[i]);
                }
            }
        }

        /// <summary>Writes vertices (x y z [m], nx ny nz) and triangles (vertex_indices).</summary>
        /// <exception cref="IOException">The file cannot be written.</exception>
        public static void WriteMesh(string file, SurfaceMesh mesh)
        {
            string[] vertex = { "float x", "float y", "float z", "float nx", "float ny", "float nz" };
            string header = Element("vertex", mesh.VertexCount, vertex) + Element("face", mesh.TriangleCount, "list uchar int vertex_indices");
            using (BinaryWriter writer = Open(file, header))
            {
                for (int i = 0; i < mesh.VertexCount; i++)
                {
                    Write(writer, mesh.Positions[i]);
                    Write(writer, mesh.Normals[i]);
                }
                for (int i = 0; i < mesh.Indices.Length; i += 3)
                {
                    writer.Write((byte)3);
                    for (int corner = 0; corner < 3; corner++)
                        writer.Write(mesh.Indices[i + corner]);
                }
            }
        }

        static BinaryWriter Open(string file, string elements)
        {
            string folder = Path.GetDirectoryName(Path.GetFullPath(file));
            Directory.CreateDirectory(folder);
            if (!BitConverter.IsLittleEndian)
                throw new PlatformNotSupportedException("PLY files are written on little-endian machines only.");
            var writer = new BinaryWriter(new BufferedStream(File.Create(file), 1 << 16));
            writer.Write(Encoding.ASCII.GetBytes("ply\nformat binary_little_endian 1.0\n" + elements + "end_header\n"));
            return writer;
        }

        static string Element(string name, int count, params string[] properties)
        {
            var text = new StringBuilder($"element {name} {count}\n");
            foreach (string property in properties)
                text.Append("property ").Append(property).Append('\n');
            return text.ToString();
        }

        static void Write(BinaryWriter writer, Vector3 value)
        {
            writer.Write(value.x);
            writer.Write(value.y);
            writer.Write(value.z);
        }
    }
}
