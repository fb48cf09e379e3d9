using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Text;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>A folder for particle files that goes with it, and PLY files of every kind, written number by number.</summary>
    public sealed class SequenceFiles : IDisposable
    {
        public static readonly string[] AllProperties = { "float x", "float y", "float z", "float vx", "float vy", "float vz", "uint id" };

        /// <summary>An empty folder.</summary>
        public string Folder { get; } = Directory.CreateDirectory(TestFolder.Fresh()).FullName;

        /// <summary>Path of a file in the folder.</summary>
        public string this[string name] => Path.Combine(Folder, name);

        public void Dispose() => TestFolder.Delete(Folder);

        /// <summary>A PLY file of particles.</summary>
        /// <param name="particles">The particles.</param>
        /// <param name="format">ascii, binary_little_endian or binary_big_endian.</param>
        /// <param name="properties">Types and names; what a particle does not have gets its place in the file.</param>
        /// <param name="before">Lines of the header that stand before the particles.</param>
        /// <param name="rows">Bytes of the elements of those lines.</param>
        public static byte[] Ply(IReadOnlyList<FluidParticle> particles, string format = "binary_little_endian", string[] properties = null,
            string before = "", byte[] rows = null)
        {
            properties ??= AllProperties;
            var header = new StringBuilder($"ply\nformat {format} 1.0\n{before}element vertex {particles.Count}\n");
            foreach (string property in properties) header.Append("property ").Append(property).Append('\n');
            var bytes = new List<byte>(Encoding.ASCII.GetBytes(header.Append("end_header\n").ToString()));
            if (rows != null) bytes.AddRange(rows);
            for (int i = 0; i < particles.Count; i++)
            {
                for (int p = 0; p < properties.Length; p++)
                {
                    string[] words = properties[p].Split(' ');
                    double value = ValueOf(particles[i], words[1], i);
                    if (format ==
                        "ascii") bytes
                            .AddRange(
                                Encoding.ASCII.GetBytes(value.ToString("R", CultureInfo.InvariantCulture) +
                                    (p + 1 < properties.Length ? " " : "\n")));
                    else bytes.AddRange(BytesOf(value, words[0], format == "binary_big_endian"));
                }
            }
            return bytes.ToArray();
        }

        private static double ValueOf(in FluidParticle particle, string name, int place)
        {
            switch (name)
            {
                case "x": return particle.Position.x;
                case "y": return particle.Position.y;
                case "z": return particle.Position.z;
                case "vx": return particle.VelT0.x;
                case "vy": return particle.VelT0.y;
                case "vz": return particle.VelT0.z;
                case "id": return particle.Id;
                default: return place % 100;
            }
        }

        private static byte[] BytesOf(double value, string type, bool big)
        {
            byte[] bytes = Little(value, type);
            if (big) Array.Reverse(bytes);
            return bytes;
        }

        private static byte[] Little(double value, string type)
        {
            switch (type)
            {
                case "char": case "int8": return new[] { (byte)(sbyte)value };
                case "uchar": case "uint8": return new[] { (byte)value };
                case "short": case "int16": return BitConverter.GetBytes((short)value);
                case "ushort": case "uint16": return BitConverter.GetBytes((ushort)value);
                case "int": case "int32": return BitConverter.GetBytes((int)value);
                case "uint": case "uint32": return BitConverter.GetBytes((uint)value);
                case "double": case "float64": return BitConverter.GetBytes(value);
                default: return BitConverter.GetBytes((float)value);
            }
        }

        /// <summary>Writes frames as a sequence.</summary>
        /// <param name="times">Their times [s].</param>
        /// <param name="frame">The particles of each.</param>
        /// <param name="domainSize">Edge lengths of the domain [m].</param>
        /// <param name="spacing">Particle spacing [m].</param>
        public void Write(IReadOnlyList<double> times, Func<int, IReadOnlyList<FluidParticle>> frame, Vector3 domainSize, float spacing)
        {
            using (var writer = new FluidSequenceWriter(Folder, domainSize, spacing, "test"))
                for (int i = 0; i < times.Count; i++) writer.Write(times[i], frame(i));
        }
    }
}
