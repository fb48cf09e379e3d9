using System.Linq;
using System.Runtime.InteropServices;
using System;
using Headless.Shaders;
using UnityEngine;

namespace Headless.Engine;

/// <summary>Writes values into constant buffers in D3D11's layout.</summary>
internal static class ConstantPacker
{
    public static void Write(Span<byte> block, ConstantMember member, ShaderValue value)
    {
        switch (value.Kind)
        {
            case ShaderValueKind.Matrix or ShaderValueKind.MatrixArray:
                WriteMatrices(block, member, value.Floats);
                break;
            case ShaderValueKind.FloatArray:
                WriteElements(block, member, value.Floats, 1);
                break;
            case ShaderValueKind.VectorArray:
                WriteElements(block, member, value.Floats, 4);
                break;
            case ShaderValueKind.Integer:
                WriteInteger(block, member, value.Integer);
                break;
            case ShaderValueKind.Color:
                Color linear = ((Color)value.Vector).linear;
                WriteElements(block, member, [linear.r, linear.g, linear.b, linear.a], 4);
                break;
            default:
                WriteElements(block, member, value.Floats, value.FloatCount);
                break;
        }
    }

    /// <summary>Copies bytes as they are, as far as the member reaches: what Unity does for compute shaders.</summary>
    public static void WriteRaw(Span<byte> block, int offset, int size, ReadOnlySpan<byte> data) =>
        data[..Math.Min(size, data.Length)].CopyTo(block[offset..]);

    private static bool IsInteger(ConstantMember member) => member.Type is "int" or "uint" or "bool";

    private static int Components(ConstantMember member)
    {
        if (member.ArrayLength > 0)
        {
            return (member.Size - ((member.ArrayLength - 1) * member.ArrayStride)) / 4;
        }

        return member.Size / 4;
    }

    private static void WriteInteger(Span<byte> block, ConstantMember member, int value)
    {
        if (IsInteger(member))
        {
            MemoryMarshal.Write(block[member.Offset..], in value);
        }
        else
        {
            float number = value;
            MemoryMarshal.Write(block[member.Offset..], in number);
        }
    }

    private static void WriteElements(Span<byte> block, ConstantMember member, ReadOnlySpan<float> values, int perElement)
    {
        int elements = Math.Min(Math.Max(1, member.ArrayLength), values.Length / perElement);
        int count = Math.Min(perElement, Components(member));
        bool integer = IsInteger(member);
        for (int e = 0; e < elements; e++)
        {
            Span<byte> target = block[(member.Offset + (e * member.ArrayStride))..];
            ReadOnlySpan<float> source = values.Slice(e * perElement, count);
            if (!integer)
            {
                MemoryMarshal.AsBytes(source).CopyTo(target);
                continue;
            }

            Span<int> integers = MemoryMarshal.Cast<byte, int>(target);
            for (int c = 0; c < count; c++)
            {
                integers[c] = (int)source[c];
            }
        }
    }

    private static void WriteMatrices(Span<byte> block, ConstantMember member, ReadOnlySpan<float> values)
    {
        if (!member.IsMatrix)
        {
            MemoryMarshal.AsBytes(values[..Math.Min(values.Length, member.Size / 4)]).CopyTo(block[member.Offset..]);
            return;
        }

        int matrices = Math.Min(Math.Max(1, member.ArrayLength), values.Length / 16);
        int lines = member.RowMajor ? member.Rows : member.Columns;
        int length = member.RowMajor ? member.Columns : member.Rows;
        for (int m = 0; m < matrices; m++)
        {
            ReadOnlySpan<float> source = values.Slice(m * 16, 16);
            int offset = member.Offset + (m * member.ArrayStride);
            for (int line = 0; line < lines; line++)
            {
                Span<float> target = MemoryMarshal.Cast<byte, float>(block[(offset + (line * 16))..]);
                for (int i = 0; i < length; i++)
                {
                    target[i] = member.RowMajor ? source[(i * 4) + line] : source[(line * 4) + i];
                }
            }
        }
    }
}
