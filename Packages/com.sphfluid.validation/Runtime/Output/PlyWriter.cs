using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Writes particles and surfaces as binary little-endian PLY, in world space and SI units.</summary>
    public static class PlyWriter
    {
        private static readonly string[] place = { "double x", "double y", "double z" };

        /// <summary>
        /// Writes one vertex a particle, in the order of their ids: x y z [m] as double, vx vy vz [m/s], density [kg/m³],
        /// pressure [Pa] as float, id as uint.
        /// </summary>
        /// <exception cref="IOException">The file cannot be written.</exception>
        public static void WriteParticles(string file, FluidSnapshot snapshot)
        {
            string[] properties = { "float vx", "float vy", "float vz", "float density", "float pressure", "uint id" };
            Write(file, snapshot.LocalToWorld, Element("vertex", snapshot.Count, place.Concat(properties)), writer =>
            {
                for (int i = 0; i < snapshot.Count; i++)
                {
                    Write(writer, snapshot.PositionOf(i));
                    Write(writer, snapshot.Velocities[i]);
                    writer.Write(snapshot.Densities[i]);
                    writer.Write(snapshot.Pressures[i]);
                    writer.Write(snapshot.Ids[i]);
                }
            });
        }

        /// <summary>Writes vertices (x y z [m] as double, nx ny nz) and triangles (vertex_indices).</summary>
        /// <param name="file">The file.</param>
        /// <param name="mesh">In the simulation's space.</param>
        /// <param name="localToWorld">Turns and moves it to world space.</param>
        /// <exception cref="IOException">The file cannot be written.</exception>
        public static void WriteMesh(string file, SurfaceMesh mesh, Matrix4x4 localToWorld)
        {
            string[] normal = { "float nx", "float ny", "float nz" };
            string header = Element("vertex", mesh.VertexCount, place.Concat(normal)) +
                Element("face", mesh.TriangleCount, new[] { "list uchar int vertex_indices" });
            Write(file, localToWorld, header, writer =>
            {
                for (int i = 0; i < mesh.VertexCount; i++)
                {
                    Write(writer, new WorldPoint(localToWorld, mesh.Positions[i]));
                    Write(writer, localToWorld.MultiplyVector(mesh.Normals[i]));
                }
                for (int i = 0; i < mesh.Indices.Length; i += 3)
                {
                    writer.Write((byte)3);
                    for (int corner = 0; corner < 3; corner++) writer.Write(mesh.Indices[i + corner]);
                }
            });
        }

        private static void Write(string file, in Matrix4x4 localToWorld, string elements, Action<BinaryWriter> write)
        {
            if (!BitConverter.IsLittleEndian)
            {
                throw new PlatformNotSupportedException("PLY files are written on little-endian machines only.");
            }
            Vector3 centre = localToWorld.GetColumn(3);
            string comment =
                FormattableString.Invariant($"comment metres in world space; the centre of the domain is at {centre.x:R} {centre.y:R} ") +
                FormattableString.Invariant($"{centre.z:R}\n");
            WholeFile.Write(file, stream =>
            {
                using (var writer = new BinaryWriter(stream))
                {
                    writer.Write(Encoding.ASCII.GetBytes("ply\nformat binary_little_endian 1.0\n" + comment + elements + "end_header\n"));
                    write(writer);
                }
            });
        }

        private static string Element(string name, int count, IEnumerable<string> properties)
        {
            var text = new StringBuilder($"element {name} {count}\n");
            foreach (string property in properties) text.Append("property ").Append(property).Append('\n');
            return text.ToString();
        }

        private static void Write(BinaryWriter writer, in WorldPoint point)
        {
            writer.Write(point.X);
            writer.Write(point.Y);
            writer.Write(point.Z);
        }

        private static void Write(BinaryWriter writer, Vector3 value)
        {
            writer.Write(value.x);
            writer.Write(value.y);
            writer.Write(value.z);
        }
    }
}
