using System.Threading;
using Headless.Vulkan;

namespace Headless.Engine;

/// <summary>Bytes of all live textures.</summary>
internal static class TextureMemory
{
    private static long bytes;

    public static ulong Bytes => (ulong)Interlocked.Read(ref bytes);

    public static GpuTexture Create(GpuTextureDescription description, string name)
    {
        Interlocked.Add(ref bytes, SizeOf(description));
        return GraphicsDevice.Device.CreateTexture(description, name);
    }

    public static void Release(GpuTexture? texture)
    {
        if (texture is not null)
        {
            Interlocked.Add(ref bytes, -SizeOf(texture.Description));
            texture.Dispose();
        }
    }

    private static long SizeOf(GpuTextureDescription d) =>
        (long)d.Width * d.Height * d.Depth * d.Layers * d.Samples * TextureFormats.BytesPerTexel(d.Format) * (d.MipLevels > 1 ? 4 : 3) / 3;
}
