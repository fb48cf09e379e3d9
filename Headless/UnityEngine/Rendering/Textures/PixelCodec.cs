using System.Buffers.Binary;
using System.Runtime.InteropServices;
using System;
using UnityEngine;

namespace Headless.Engine;

/// <summary>Reads and writes pixels of the CPU copy of a texture; values are as stored, without sRGB conversion.</summary>
internal static class PixelCodec
{
    public static int BytesPerPixel(TextureFormat format) => format switch
    {
        TextureFormat.Alpha8 or TextureFormat.R8 => 1,
        TextureFormat.RG16 or TextureFormat.R16 or TextureFormat.RHalf => 2,
        TextureFormat.RGB24 => 3,
        TextureFormat.RGBA32 or TextureFormat.ARGB32 or TextureFormat.BGRA32 or TextureFormat.RGHalf or TextureFormat.RFloat or TextureFormat.RG32 => 4,
        TextureFormat.RGBAHalf or TextureFormat.RGFloat or TextureFormat.RGBA64 => 8,
        TextureFormat.RGBAFloat => 16,
        _ => throw new NotSupportedException($"Texture format {format} has no readable pixels on this device."),
    };

    public static Color Read(TextureFormat format, ReadOnlySpan<byte> p) => format switch
    {
        TextureFormat.Alpha8 => new Color(1f, 1f, 1f, p[0] / 255f),
        TextureFormat.R8 => new Color(p[0] / 255f, 0f, 0f, 1f),
        TextureFormat.RG16 => new Color(p[0] / 255f, p[1] / 255f, 0f, 1f),
        TextureFormat.RGB24 => new Color(p[0] / 255f, p[1] / 255f, p[2] / 255f, 1f),
        TextureFormat.RGBA32 => new Color(p[0] / 255f, p[1] / 255f, p[2] / 255f, p[3] / 255f),
        TextureFormat.ARGB32 => new Color(p[1] / 255f, p[2] / 255f, p[3] / 255f, p[0] / 255f),
        TextureFormat.BGRA32 => new Color(p[2] / 255f, p[1] / 255f, p[0] / 255f, p[3] / 255f),
        TextureFormat.R16 => new Color(Short(p, 0), 0f, 0f, 1f),
        TextureFormat.RG32 => new Color(Short(p, 0), Short(p, 1), 0f, 1f),
        TextureFormat.RGBA64 => new Color(Short(p, 0), Short(p, 1), Short(p, 2), Short(p, 3)),
        TextureFormat.RHalf => new Color(Half(p, 0), 0f, 0f, 1f),
        TextureFormat.RGHalf => new Color(Half(p, 0), Half(p, 1), 0f, 1f),
        TextureFormat.RGBAHalf => new Color(Half(p, 0), Half(p, 1), Half(p, 2), Half(p, 3)),
        TextureFormat.RFloat => new Color(Float(p, 0), 0f, 0f, 1f),
        TextureFormat.RGFloat => new Color(Float(p, 0), Float(p, 1), 0f, 1f),
        _ => new Color(Float(p, 0), Float(p, 1), Float(p, 2), Float(p, 3)),
    };

    public static void Write(TextureFormat format, Span<byte> p, Color c)
    {
        switch (format)
        {
            case TextureFormat.Alpha8:
                p[0] = Byte(c.a);
                break;
            case TextureFormat.ARGB32:
                (p[0], p[1], p[2], p[3]) = (Byte(c.a), Byte(c.r), Byte(c.g), Byte(c.b));
                break;
            case TextureFormat.BGRA32:
                (p[0], p[1], p[2], p[3]) = (Byte(c.b), Byte(c.g), Byte(c.r), Byte(c.a));
                break;
            default:
                WriteChannels(format, p, [c.r, c.g, c.b, c.a]);
                break;
        }
    }

    private static void WriteChannels(TextureFormat format, Span<byte> p, ReadOnlySpan<float> channels)
    {
        int channelBytes = format switch
        {
            TextureFormat.R8 or TextureFormat.RG16 or TextureFormat.RGB24 or TextureFormat.RGBA32 => 1,
            TextureFormat.RFloat or TextureFormat.RGFloat or TextureFormat.RGBAFloat => 4,
            _ => 2,
        };
        bool half = format is TextureFormat.RHalf or TextureFormat.RGHalf or TextureFormat.RGBAHalf;
        int count = BytesPerPixel(format) / channelBytes;
        for (int i = 0; i < count; i++)
        {
            Span<byte> target = p[(i * channelBytes)..];
            switch (channelBytes)
            {
                case 1:
                    target[0] = Byte(channels[i]);
                    break;
                case 4:
                    MemoryMarshal.Write(target, channels[i]);
                    break;
                default:
                    if (half)
                    {
                        BinaryPrimitives.WriteHalfLittleEndian(target, (Half)channels[i]);
                    }
                    else
                    {
                        BinaryPrimitives.WriteUInt16LittleEndian(target, (ushort)MathF.Round(Math.Clamp(channels[i], 0f, 1f) * 65535f));
                    }

                    break;
            }
        }
    }

    private static byte Byte(float value) => (byte)MathF.Round(Math.Clamp(value, 0f, 1f) * 255f);

    private static float Short(ReadOnlySpan<byte> p, int i) => BinaryPrimitives.ReadUInt16LittleEndian(p[(i * 2)..]) / 65535f;

    private static float Half(ReadOnlySpan<byte> p, int i) => (float)BinaryPrimitives.ReadHalfLittleEndian(p[(i * 2)..]);

    private static float Float(ReadOnlySpan<byte> p, int i) => BinaryPrimitives.ReadSingleLittleEndian(p[(i * 4)..]);
}
