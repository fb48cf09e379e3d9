using System;
using System.Collections.Generic;

namespace SphFluid
{
    /// <summary>
    /// The header of a PLY file (Turk, "The PLY polygon file format", 1994): what stands behind it, as far as the particles. Read again and
    /// again by one object, without garbage.
    /// </summary>
    internal sealed class PlyHeader
    {
        /// <summary>A header ends within so many bytes.</summary>
        public const int MostBytes = 1 << 16;

        private const int X = 0, VelocityX = 3, Id = 6;

        private static readonly string[] TypeNames =
        {
            "char", "int8", "uchar", "uint8", "short", "int16", "ushort", "uint16", "int", "int32", "uint", "uint32", "float", "float32",
            "double", "float64",
        };

        private static readonly int[] Sizes = { 1, 1, 2, 2, 4, 4, 4, 8 };

        private readonly List<PlyElement> elements = new List<PlyElement>();
        private readonly List<PlyProperty> properties = new List<PlyProperty>();
        private int fields; // bits of the fields that particles have

        /// <summary>Names of the properties that make a particle.</summary>
        public static readonly string[] FieldNames = { "x", "y", "z", "vx", "vy", "vz", "id" };

        /// <summary>How numbers are written.</summary>
        public PlyEncoding Encoding { get; private set; }

        /// <summary>Place of the first byte behind the header.</summary>
        public int DataStart { get; private set; }

        /// <summary>Elements that stand before the particles.</summary>
        public List<PlyElement> Before => elements;

        /// <summary>The particles.</summary>
        public PlyElement Vertex { get; private set; }

        /// <summary>Whether nothing stands behind the particles.</summary>
        public bool VertexIsLast { get; private set; }

        /// <summary>Properties of all elements.</summary>
        public List<PlyProperty> Properties => properties;

        /// <summary>Bytes of a particle in a binary file.</summary>
        public int Stride { get; private set; }

        /// <summary>Whether particles have velocities.</summary>
        public bool HasVelocities => Has(VelocityX, 3);

        /// <summary>Whether particles have numbers.</summary>
        public bool HasIds => Has(Id, 1);

        /// <summary>Whether particles lie in the file as <see cref="StoredParticle"/> does in memory.</summary>
        public bool IsPlain { get; private set; }

        /// <summary>Bytes of a number.</summary>
        public static int SizeOf(PlyType type) => Sizes[(int)type];

        /// <summary>Reads the header.</summary>
        /// <param name="file">The file, or its first bytes.</param>
        /// <exception cref="SequenceException">It has none that can be read, or none of particles.</exception>
        public void Read(ReadOnlySpan<byte> file)
        {
            elements.Clear();
            properties.Clear();
            fields = 0;
            Vertex = default;
            bool hasVertex = false, hasFormat = false, inVertex = false;
            int place = 0;
            if (!Is(Line(file, ref place), "ply"))
            {
                throw new SequenceException("is no PLY file", "Give the folder files in the PLY format only.");
            }
            while (true)
            {
                ReadOnlySpan<byte> line = Line(file, ref place);
                ReadOnlySpan<byte> word = Word(ref line);
                if (Is(word, "end_header")) break;
                if (word.Length == 0 || Is(word, "comment") || Is(word, "obj_info")) continue;
                if (Is(word, "format")) (Encoding, hasFormat) = (EncodingOf(Word(ref line)), true);
                else if (Is(word, "element"))
                {
                    bool isVertex = Is(Word(ref line), "vertex");
                    inVertex = isVertex && !hasVertex;
                    if (hasVertex && !inVertex) VertexIsLast = false;
                    var element = new PlyElement { Count = CountOf(Word(ref line)), First = properties.Count };
                    if (inVertex) (Vertex, hasVertex, VertexIsLast) = (element, true, true);
                    else if (!hasVertex) elements.Add(element);
                }
                else if (Is(word, "property"))
                {
                    if (hasVertex && !inVertex) continue;
                    if (!hasVertex && elements.Count == 0) throw Unreadable();
                    AddProperty(ref line, inVertex);
                }
                else throw Unreadable();
            }
            if (!hasFormat) throw Unreadable();
            if (!hasVertex)
            {
                throw new SequenceException("has no particles: its header names no element vertex",
                    "Write particles as the element vertex with the properties x, y and z.");
            }
            DataStart = place;
            Finish();
        }

        private void AddProperty(ref ReadOnlySpan<byte> line, bool inVertex)
        {
            var property = new PlyProperty { Field = -1 };
            ReadOnlySpan<byte> word = Word(ref line);
            if (Is(word, "list"))
            {
                property.IsList = true;
                property.CountType = TypeOf(Word(ref line));
                word = Word(ref line);
            }
            property.Type = TypeOf(word);
            if (inVertex) property.Field = FieldOf(Word(ref line), property.IsList);
            properties.Add(property);
            if (inVertex)
            {
                PlyElement vertex = Vertex;
                vertex.Properties++;
                Vertex = vertex;
                return;
            }
            PlyElement element = elements[elements.Count - 1];
            element.Properties++;
            elements[elements.Count - 1] = element;
        }

        private int FieldOf(ReadOnlySpan<byte> name, bool isList)
        {
            if (isList) throw new SequenceException("has lists among the properties of its particles", "Write one number a property.");
            for (int i = 0; i < FieldNames.Length; i++)
            {
                if (!Is(name, FieldNames[i])) continue;
                if (Has(i, 1)) throw Unreadable();
                fields |= 1 << i;
                return i;
            }
            return -1;
        }

        private void Finish()
        {
            if (!Has(X, 3))
            {
                throw new SequenceException("has particles without x, y and z", "Write these properties of the element vertex.");
            }
            if (!HasVelocities && (fields & (7 << VelocityX)) != 0)
            {
                throw new SequenceException("has some of vx, vy and vz, and not all", "Write all three, or none.");
            }
            Stride = 0;
            IsPlain = Encoding == PlyEncoding.LittleEndian && Vertex.Properties == FieldNames.Length;
            for (int i = 0; i < Vertex.Properties; i++)
            {
                PlyProperty property = properties[Vertex.First + i];
                Stride += SizeOf(property.Type);
                IsPlain &= property.Field == i && property.Type == (i == Id ? PlyType.UInt32 : PlyType.Float32);
            }
        }

        private bool Has(int first, int count)
        {
            int asked = ((1 << count) - 1) << first;
            return (fields & asked) == asked;
        }

        private static PlyEncoding EncodingOf(ReadOnlySpan<byte> word) =>
            Is(word, "ascii") ? PlyEncoding.Ascii : Is(word, "binary_little_endian") ? PlyEncoding.LittleEndian
                : Is(word, "binary_big_endian") ? PlyEncoding.BigEndian : throw Unreadable();

        private static PlyType TypeOf(ReadOnlySpan<byte> word)
        {
            for (int i = 0; i < TypeNames.Length; i++)
                if (Is(word, TypeNames[i])) return (PlyType)(i / 2);
            throw Unreadable();
        }

        private static long CountOf(ReadOnlySpan<byte> word)
        {
            long count = 0;
            foreach (byte digit in word)
            {
                if (digit < '0' || digit > '9' || count > int.MaxValue) throw Unreadable();
                count = 10 * count + (digit - '0');
            }
            return word.Length > 0 && count <= int.MaxValue ? count : throw Unreadable();
        }

        private static ReadOnlySpan<byte> Line(ReadOnlySpan<byte> file, ref int place)
        {
            int length = file.Slice(place).IndexOf((byte)'\n');
            if (length < 0 || place + length >= MostBytes)
            {
                throw place == 0 ? new SequenceException("is no PLY file", "Give the folder files in the PLY format only.") : Unreadable();
            }
            ReadOnlySpan<byte> line = file.Slice(place, length);
            place += length + 1;
            return line.Length > 0 && line[line.Length - 1] == '\r' ? line.Slice(0, line.Length - 1) : line;
        }

        private static ReadOnlySpan<byte> Word(ref ReadOnlySpan<byte> line)
        {
            int begin = 0;
            while (begin < line.Length && line[begin] <= ' ') begin++;
            int end = begin;
            while (end < line.Length && line[end] > ' ') end++;
            ReadOnlySpan<byte> word = line.Slice(begin, end - begin);
            line = line.Slice(end);
            return word;
        }

        private static bool Is(ReadOnlySpan<byte> word, string text)
        {
            if (word.Length != text.Length) return false;
            for (int i = 0; i < word.Length; i++)
                if (word[i] != text[i]) return false;
            return true;
        }

        private static SequenceException Unreadable() => new SequenceException("has a header that cannot be read");
    }
}
