using Headless.Vulkan.Native;

namespace Headless.Vulkan;

/// <summary>One sampler for each description.</summary>
internal sealed unsafe class SamplerCache(DeviceContext context) : IDisposable
{
    private readonly Dictionary<GpuSamplerDescription, GpuSampler> samplers = [];

    public GpuSampler Get(GpuSamplerDescription description)
    {
        if (!samplers.TryGetValue(description, out GpuSampler? sampler))
        {
            samplers[description] = sampler = new GpuSampler(context, description);
        }

        return sampler;
    }

    public void Dispose()
    {
        foreach (GpuSampler sampler in samplers.Values)
        {
            Vk.vkDestroySampler(context.Handle, sampler.Handle, null);
        }

        samplers.Clear();
    }
}
