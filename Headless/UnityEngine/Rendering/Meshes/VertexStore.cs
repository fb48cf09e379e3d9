using System.Buffers.Binary;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System;
using UnityEngine.Rendering;
using UnityEngine;

namespace Headless.Engine;

/// <summary>The vertices of a mesh as bytes in streams, in the layout that its attributes describe.</summary>
internal sealed class VertexStore
{
    private VertexAttributeDescriptor[] attributes = [];
    private byte[][] streams = [];
    private int[] strides = [];

    public int Count { get; private set; }
    public IReadOnlyList<VertexAttributeDescriptor> Attributes => attributes;
    public int StreamCount => streams.Length;

    public static int FormatSize(VertexAttributeFormat format) => format switch
    {
        VertexAttributeFormat.Float32 or VertexAttributeFormat.UInt32 or VertexAttributeFormat.SInt32 => 4,
        VertexAttributeFormat.Float16 or VertexAttributeFormat.UNorm16 or VertexAttributeFormat.SNorm16
            or VertexAttributeFormat.UInt16 or VertexAttributeFormat.SInt16 => 2,
        _ => 1,
    };

    public byte[] Stream(int index) => streams[index];

    public int Stride(int stream) => stream < strides.Length ? strides[stream] : 0;

    public int Find(VertexAttribute attribute) => Array.FindIndex(attributes, a => a.attribute == attribute);

    public bool Has(VertexAttribute attribute) => Find(attribute) >= 0;

    public int Offset(VertexAttribute attribute)
    {
        int index = Find(attribute);
        int offset = 0;
        for (int i = 0; i < index; i++)
        {
            if (attributes[i].stream == attributes[index].stream)
            {
                offset += FormatSize(attributes[i].format) * attributes[i].dimension;
            }
        }

        return index < 0 ? -1 : offset;
    }

    public void CopyFrom(VertexStore other)
    {
        (attributes, strides, Count) = (other.attributes, other.strides, other.Count);
        streams = [.. other.streams.Select(s => (byte[])s.Clone())];
    }

    public void Clear()
    {
        (attributes, streams, strides, Count) = ([], [], [], 0);
    }

    /// <summary>A new layout; content of attributes that stay is kept where keep is set.</summary>
    public void SetLayout(int count, IReadOnlyList<VertexAttributeDescriptor> layout, bool keep)
    {
        VertexStore? old = keep && Count > 0 ? (VertexStore)MemberwiseClone() : null;
        attributes = [.. layout.OrderBy(a => a.attribute)];
        int streamCount = attributes.Length == 0 ? 0 : attributes.Max(a => a.stream) + 1;
        strides = new int[streamCount];
        foreach (VertexAttributeDescriptor a in attributes)
        {
            if (FormatSize(a.format) * a.dimension % 4 != 0)
            {
                throw new ArgumentException($"Vertex attribute {a} does not fill a multiple of 4 bytes.");
            }

            strides[a.stream] += FormatSize(a.format) * a.dimension;
        }

        Count = count;
        streams = [.. strides.Select(s => new byte[s * count])];
        if (old is not null)
        {
            foreach (VertexAttributeDescriptor a in attributes.Where(a => old.Has(a.attribute)))
            {
                Write(a.attribute, old.Read(a.attribute), Math.Min(count, old.Count));
            }
        }
    }

    /// <summary>Writes one attribute for all vertices, adding it to the layout when it is new.</summary>
    public void Set(VertexAttribute attribute, ReadOnlySpan<Vector4> values, int dimension, VertexAttributeFormat format)
    {
        int index = Find(attribute);
        bool same = index >= 0 && attributes[index].dimension == dimension && attributes[index].format == format;
        if (attribute == VertexAttribute.Position && values.Length != Count)
        {
            SetLayout(values.Length, WithAttribute(attribute, dimension, format), true);
        }
        else if (!same)
        {
            SetLayout(Count, WithAttribute(attribute, dimension, format), true);
        }

        Write(attribute, values, values.Length);
    }

    public void Remove(VertexAttribute attribute)
    {
        if (Has(attribute))
        {
            SetLayout(Count, [.. attributes.Where(a => a.attribute != attribute)], true);
        }
    }

    /// <summary>All values of an attribute; missing components are 0. Null-length when the attribute is absent.</summary>
    public Vector4[] Read(VertexAttribute attribute)
    {
        int index = Find(attribute);
        if (index < 0)
        {
            return [];
        }

        VertexAttributeDescriptor a = attributes[index];
        int stride = strides[a.stream];
        int offset = Offset(attribute);
        int size = FormatSize(a.format);
        var values = new Vector4[Count];
        for (int i = 0; i < Count; i++)
        {
            ReadOnlySpan<byte> p = streams[a.stream].AsSpan((i * stride) + offset);
            for (int c = 0; c < a.dimension; c++)
            {
                values[i][c] = ReadComponent(a.format, p[(c * size)..]);
            }
        }

        return values;
    }

    public VertexStore Clone()
    {
        var copy = (VertexStore)MemberwiseClone();
        copy.streams = [.. streams.Select(s => (byte[])s.Clone())];
        return copy;
    }

    private List<VertexAttributeDescriptor> WithAttribute(VertexAttribute attribute, int dimension, VertexAttributeFormat format) =>
        [.. attributes.Where(a => a.attribute != attribute), new VertexAttributeDescriptor(attribute, format, dimension)];

    private void Write(VertexAttribute attribute, ReadOnlySpan<Vector4> values, int count)
    {
        VertexAttributeDescriptor a = attributes[Find(attribute)];
        int stride = strides[a.stream];
        int offset = Offset(attribute);
        int size = FormatSize(a.format);
        for (int i = 0; i < count; i++)
        {
            Span<byte> p = streams[a.stream].AsSpan((i * stride) + offset);
            Vector4 v = values[i];
            for (int c = 0; c < a.dimension; c++)
            {
                WriteComponent(a.format, p[(c * size)..], v[c]);
            }
        }
    }

    private static float ReadComponent(VertexAttributeFormat format, ReadOnlySpan<byte> p) => format switch
    {
        VertexAttributeFormat.Float32 => BinaryPrimitives.ReadSingleLittleEndian(p),
        VertexAttributeFormat.Float16 => (float)BinaryPrimitives.ReadHalfLittleEndian(p),
        VertexAttributeFormat.UNorm8 => p[0] / 255f,
        VertexAttributeFormat.SNorm8 => Math.Max(-1f, (sbyte)p[0] / 127f),
        VertexAttributeFormat.UNorm16 => BinaryPrimitives.ReadUInt16LittleEndian(p) / 65535f,
        VertexAttributeFormat.SNorm16 => Math.Max(-1f, BinaryPrimitives.ReadInt16LittleEndian(p) / 32767f),
        VertexAttributeFormat.UInt8 => p[0],
        VertexAttributeFormat.SInt8 => (sbyte)p[0],
        VertexAttributeFormat.UInt16 => BinaryPrimitives.ReadUInt16LittleEndian(p),
        VertexAttributeFormat.SInt16 => BinaryPrimitives.ReadInt16LittleEndian(p),
        VertexAttributeFormat.UInt32 => BinaryPrimitives.ReadUInt32LittleEndian(p),
        _ => BinaryPrimitives.ReadInt32LittleEndian(p),
    };

    private static void WriteComponent(VertexAttributeFormat format, Span<byte> p, float value)
    {
        switch (format)
        {
            case VertexAttributeFormat.Float32:
                BinaryPrimitives.WriteSingleLittleEndian(p, value);
                break;
            case VertexAttributeFormat.Float16:
                BinaryPrimitives.WriteHalfLittleEndian(p, (Half)value);
                break;
            case VertexAttributeFormat.UNorm8:
                p[0] = (byte)MathF.Round(Math.Clamp(value, 0f, 1f) * 255f);
                break;
            case VertexAttributeFormat.SNorm8:
                p[0] = (byte)(sbyte)MathF.Round(Math.Clamp(value, -1f, 1f) * 127f);
                break;
            case VertexAttributeFormat.UNorm16:
                BinaryPrimitives.WriteUInt16LittleEndian(p, (ushort)MathF.Round(Math.Clamp(value, 0f, 1f) * 65535f));
                break;
            case VertexAttributeFormat.SNorm16:
                BinaryPrimitives.WriteInt16LittleEndian(p, (short)MathF.Round(Math.Clamp(value, -1f, 1f) * 32767f));
                break;
            case VertexAttributeFormat.UInt8 or VertexAttributeFormat.SInt8:
                p[0] = (byte)(int)value;
                break;
            case VertexAttributeFormat.UInt16 or VertexAttributeFormat.SInt16:
                BinaryPrimitives.WriteUInt16LittleEndian(p, (ushort)(int)value);
                break;
            default:
                BinaryPrimitives.WriteUInt32LittleEndian(p, (uint)(long)value);
                break;
        }
    }
}
