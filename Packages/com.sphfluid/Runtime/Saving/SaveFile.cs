using System;
using System.Collections.Generic;
using System.IO;
using System.Runtime.InteropServices;
using System.Text;

namespace SphFluid
{
    /// <summary>
    /// The bytes of a save: a header of 32 bytes (SPHFLUID, version, number of sections, length of all of them, CRC-32 of the header so
    /// far), then sections, each with a header of 24 bytes (name, length, CRC-32 of name, length and contents) and its contents. Little
    /// endian.
    /// </summary>
    internal static class SaveFile
    {
        /// <summary>Grows with each change of what sections hold; others are refused.</summary>
        public const uint Version = 3u;

        private const int HeaderSize = 32, SectionHeaderSize = 24, NameSize = 8;
        private const int Chunk = 1 << 20;

        // "SPHFLUID"
        private const ulong Magic = 0x4449554C46485053ul;

        [StructLayout(LayoutKind.Sequential)]
        private struct Header
        {
            public ulong Magic;
            public uint Version;
            public int Sections;
            public long Length;
            public uint Unused;
            public uint Check;
        }

        [StructLayout(LayoutKind.Sequential)]
        private struct SectionHeader
        {
            public ulong Name;
            public long Length;
            public uint Unused;
            public uint Check;
        }

        /// <summary>Writes sections.</summary>
        /// <param name="stream">Receives them.</param>
        /// <param name="sections">Names, of 8 ASCII characters at most, and contents.</param>
        public static void Write(Stream stream, IReadOnlyList<(string name, SaveWriter contents)> sections)
        {
            var header = new Header { Magic = Magic, Version = Version, Sections = sections.Count };
            foreach ((string _, SaveWriter contents) in sections) header.Length += SectionHeaderSize + contents.Bytes.Length;
            header.Check = Crc32.Compute(SaveWriter.BytesOf(header).Slice(0, HeaderSize - sizeof(uint)));
            stream.Write(SaveWriter.BytesOf(header));
            foreach ((string name, SaveWriter contents) in sections)
            {
                var section = new SectionHeader { Name = NumberOf(name), Length = contents.Bytes.Length };
                section.Check = CheckOf(section, contents.Bytes);
                stream.Write(SaveWriter.BytesOf(section));
                stream.Write(contents.Bytes);
            }
        }

        /// <summary>Reads what <see cref="Write"/> wrote, and no byte behind it.</summary>
        /// <param name="stream">Where it begins.</param>
        /// <returns>Contents by name.</returns>
        /// <exception cref="InvalidDataException">It is none, of another version, or not whole; the message ends a sentence that begins
        /// with "the save".</exception>
        public static Dictionary<string, byte[]> Read(Stream stream)
        {
            byte[] first = ReadBytes(stream, HeaderSize);
            Header header = MemoryMarshal.Read<Header>(first);
            if (header.Magic != Magic) throw new InvalidDataException("is no save of a liquid");
            if (header.Version != Version)
            {
                throw new InvalidDataException($"has the version {header.Version}, and this version of the package reads {Version}");
            }
            if (header.Check != Crc32.Compute(first.AsSpan(0, HeaderSize - sizeof(uint)))) throw Altered();
            var sections = new Dictionary<string, byte[]>();
            for (int i = 0; i < header.Sections; i++)
            {
                SectionHeader section = MemoryMarshal.Read<SectionHeader>(ReadBytes(stream, SectionHeaderSize));
                if (section.Length < 0 || section.Length > Math.Min(header.Length, int.MaxValue - Chunk)) throw Altered();
                byte[] contents = ReadBytes(stream, section.Length);
                if (section.Check != CheckOf(section, contents)) throw Altered();
                sections[NameOf(section.Name)] = contents;
            }
            return sections;
        }

        private static InvalidDataException Altered() => new InvalidDataException("was altered since it was written");

        // In pieces: a length that is wrong makes no array of its size.
        private static byte[] ReadBytes(Stream stream, long count)
        {
            var taken = new byte[(int)Math.Min(count, Chunk)];
            int read = 0;
            while (read < count)
            {
                if (read == taken.Length) Array.Resize(ref taken, (int)Math.Min(count, 2L * taken.Length));
                int part = stream.Read(taken, read, taken.Length - read);
                if (part == 0) throw new InvalidDataException("was cut: bytes are missing at its end");
                read += part;
            }
            return taken;
        }

        private static uint CheckOf(in SectionHeader section, ReadOnlySpan<byte> contents) =>
            Crc32.Compute(contents, Crc32.Compute(SaveWriter.BytesOf(section).Slice(0, SectionHeaderSize - sizeof(uint))));

        private static ulong NumberOf(string name)
        {
            var bytes = new byte[NameSize];
            Encoding.ASCII.GetBytes(name, 0, name.Length, bytes, 0);
            return MemoryMarshal.Read<ulong>(bytes);
        }

        private static string NameOf(ulong number) => Encoding.ASCII.GetString(SaveWriter.BytesOf(number)).TrimEnd('\0');
    }
}
