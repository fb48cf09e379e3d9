using System;
using System.Buffers.Binary;
using System.Buffers.Text;
using System.Runtime.InteropServices;

namespace SphFluid
{
    /// <summary>Particles from the bytes of a PLY file, without garbage.</summary>
    internal static class PlyDecoder
    {
        /// <summary>Reads the particles as they stand in the file; what they lack is 0, numbers count on from 0.</summary>
        /// <param name="file">The whole file.</param>
        /// <param name="header">Its header.</param>
        /// <param name="particles">Receives as many as the header says.</param>
        /// <exception cref="SequenceException">The file is cut, or something in it is no number.</exception>
        public static void Decode(ReadOnlySpan<byte> file, PlyHeader header, Span<StoredParticle> particles)
        {
            int place = header.DataStart;
            if (header.Encoding == PlyEncoding.Ascii) DecodeText(file, header, place, particles);
            else DecodeBinary(file, header, place, particles);
        }

        private static void DecodeBinary(ReadOnlySpan<byte> file, PlyHeader header, int place, Span<StoredParticle> particles)
        {
            bool big = header.Encoding == PlyEncoding.BigEndian;
            foreach (PlyElement element in header.Before) place = Skip(file, header, element, place, big);
            long bytes = (long)header.Stride * particles.Length;
            if (bytes > file.Length - place) throw Cut(particles.Length, header.Stride > 0 ? (file.Length - place) / header.Stride : 0);
            if (header.VertexIsLast && bytes < file.Length - place) throw Longer();
            if (header.IsPlain && BitConverter.IsLittleEndian)
            {
                MemoryMarshal.Cast<byte, StoredParticle>(file.Slice(place, (int)bytes)).CopyTo(particles);
                return;
            }
            for (int i = 0; i < particles.Length; i++)
            {
                StoredParticle particle = default;
                particle.Id = (uint)i;
                for (int p = 0; p < header.Vertex.Properties; p++)
                {
                    PlyProperty property = header.Properties[header.Vertex.First + p];
                    if (property.Field >= 0) Set(ref particle, property.Field, Number(file.Slice(place), property.Type, big));
                    place += PlyHeader.SizeOf(property.Type);
                }
                particles[i] = particle;
            }
        }

        private static int Skip(ReadOnlySpan<byte> file, PlyHeader header, in PlyElement element, int place, bool big)
        {
            for (long row = 0; row < element.Count && element.Properties > 0; row++)
            {
                for (int p = 0; p < element.Properties; p++)
                {
                    PlyProperty property = header.Properties[element.First + p];
                    double count = property.IsList
                        ? Number(Rest(file, place, PlyHeader.SizeOf(property.CountType)), property.CountType, big) : 1.0;
                    long length = (property.IsList ? PlyHeader.SizeOf(property.CountType) : 0) +
                        (long)Math.Max(0.0, Math.Min(count, int.MaxValue)) * PlyHeader.SizeOf(property.Type);
                    if (length > file.Length - place) throw new SequenceException("was cut: it ends before its particles");
                    place += (int)length;
                }
            }
            return place;
        }

        private static ReadOnlySpan<byte> Rest(ReadOnlySpan<byte> file, int place, int least) =>
            file.Length - place >= least ? file.Slice(place) : throw new SequenceException("was cut: it ends before its particles");

        private static void DecodeText(ReadOnlySpan<byte> file, PlyHeader header, int place, Span<StoredParticle> particles)
        {
            ReadOnlySpan<byte> text = file.Slice(place);
            foreach (PlyElement element in header.Before) SkipText(ref text, header, element);
            for (int i = 0; i < particles.Length; i++)
            {
                StoredParticle particle = default;
                particle.Id = (uint)i;
                for (int p = 0; p < header.Vertex.Properties; p++)
                {
                    if (!TryNumber(ref text, out double number)) throw Cut(particles.Length, i);
                    int field = header.Properties[header.Vertex.First + p].Field;
                    if (field >= 0) Set(ref particle, field, number);
                }
                particles[i] = particle;
            }
            if (header.VertexIsLast && Trimmed(text).Length > 0) throw Longer();
        }

        private static void SkipText(ref ReadOnlySpan<byte> text, PlyHeader header, in PlyElement element)
        {
            for (long row = 0; row < element.Count && element.Properties > 0; row++)
            {
                for (int p = 0; p < element.Properties; p++)
                {
                    double count = 1.0;
                    if (header.Properties[element.First + p].IsList && !TryNumber(ref text, out count))
                    {
                        throw new SequenceException("was cut: it ends before its particles");
                    }
                    for (; count >= 1.0; count -= 1.0)
                        if (!TryNumber(ref text, out _)) throw new SequenceException("was cut: it ends before its particles");
                }
            }
        }

        // False at the end of the text.
        private static bool TryNumber(ref ReadOnlySpan<byte> text, out double number)
        {
            number = 0.0;
            text = Trimmed(text);
            if (text.Length == 0) return false;
            if (Utf8Parser.TryParse(text, out number, out int read) && (read == text.Length || text[read] <= ' '))
            {
                text = text.Slice(read);
                return true;
            }
            throw new SequenceException("has text where the number of a particle should be");
        }

        private static ReadOnlySpan<byte> Trimmed(ReadOnlySpan<byte> text)
        {
            int begin = 0;
            while (begin < text.Length && text[begin] <= ' ') begin++;
            return text.Slice(begin);
        }

        private static double Number(ReadOnlySpan<byte> at, PlyType type, bool big)
        {
            switch (type)
            {
                case PlyType.Int8: return (sbyte)at[0];
                case PlyType.UInt8: return at[0];
                case PlyType.Int16: return big ? BinaryPrimitives.ReadInt16BigEndian(at) : BinaryPrimitives.ReadInt16LittleEndian(at);
                case PlyType.UInt16: return big ? BinaryPrimitives.ReadUInt16BigEndian(at) : BinaryPrimitives.ReadUInt16LittleEndian(at);
                case PlyType.Int32: return Bits(at, big);
                case PlyType.UInt32: return unchecked((uint)Bits(at, big));
                case PlyType.Float32: return BitConverter.Int32BitsToSingle(Bits(at, big));
                default:
                    return BitConverter.Int64BitsToDouble(big ? BinaryPrimitives.ReadInt64BigEndian(at)
                        : BinaryPrimitives.ReadInt64LittleEndian(at));
            }
        }

        private static int Bits(ReadOnlySpan<byte> at, bool big) => big ? BinaryPrimitives.ReadInt32BigEndian(at)
            : BinaryPrimitives.ReadInt32LittleEndian(at);

        private static void Set(ref StoredParticle particle, int field, double number)
        {
            if (field < 3) particle.Position[field] = (float)number;
            else if (field < 6) particle.Velocity[field - 3] = (float)number;
            else if (number >= 0.0 && number <= uint.MaxValue && Math.Floor(number) == number) particle.Id = (uint)number;
            else throw new SequenceException(FormattableString.Invariant($"has a particle with the id {number}"),
                "Number particles by whole numbers from 0 to 4294967295.");
        }

        private static SequenceException Cut(long count, long whole) =>
            new SequenceException(FormattableString.Invariant($"was cut: it ends after {whole} of {count} particles"));

        private static SequenceException Longer() => new SequenceException("goes on behind its last particle");
    }
}
