using Headless.Files;
using Headless.Vulkan.Native;

namespace Headless.Vulkan;

/// <summary>The driver's pipeline cache, kept in the user's cache folder between runs.</summary>
internal sealed unsafe class PipelineCacheFile : IDisposable
{
    private readonly DeviceContext context;
    private readonly string path;
    private readonly int loadedSize;

    public PipelineCacheFile(DeviceContext context, string? directory)
    {
        this.context = context;
        path = Path.Combine(directory ?? UserCache.Folder, $"pipelines-{context.Physical.CacheKey}.bin");
        byte[] data = Load(path);
        loadedSize = data.Length;
        fixed (byte* first = data)
        {
            VkPipelineCacheCreateInfo info = new() { initialDataSize = (nuint)data.Length, pInitialData = first };
            VkPipelineCache handle;
            Vk.vkCreatePipelineCache(context.Handle, &info, null, &handle).Check("Creating the pipeline cache");
            Handle = handle;
        }
    }

    public VkPipelineCache Handle { get; }

    public void Dispose()
    {
        Save();
        Vk.vkDestroyPipelineCache(context.Handle, Handle, null);
    }

    private static byte[] Load(string path)
    {
        try
        {
            return File.Exists(path) ? File.ReadAllBytes(path) : [];
        }
        catch (Exception error) when (error is IOException or UnauthorizedAccessException)
        {
            return [];
        }
    }

    /// <summary>The cache only saves time: a folder that cannot be written is no error. Other processes never see half a file.</summary>
    private void Save()
    {
        nuint size = 0;
        if (Vk.vkGetPipelineCacheData(context.Handle, Handle, &size, null) != VkResult.Success || size == 0 || size == (nuint)loadedSize)
        {
            return;
        }

        byte[] data = new byte[size];
        fixed (byte* first = data)
        {
            if (Vk.vkGetPipelineCacheData(context.Handle, Handle, &size, first) != VkResult.Success)
            {
                return;
            }
        }

        string temporary = $"{path}.{Environment.ProcessId}";
        try
        {
            Directory.CreateDirectory(Path.GetDirectoryName(path)!);
            File.WriteAllBytes(temporary, data.AsSpan(0, (int)size).ToArray());
            File.Move(temporary, path, overwrite: true);
        }
        catch (Exception error) when (error is IOException or UnauthorizedAccessException)
        {
            if (File.Exists(temporary)) File.Delete(temporary);
        }
    }
}
