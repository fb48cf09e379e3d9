using System;

namespace UnityEngine.Rendering;

public struct ProfilingScope : IDisposable
{
    private readonly CommandBuffer? buffer;
    private readonly ProfilingSampler? sampler;

    public ProfilingScope(CommandBuffer? cmd, ProfilingSampler? sampler)
    {
        (buffer, this.sampler) = (cmd, sampler);
        sampler?.Begin(cmd);
    }

    public ProfilingScope(BaseCommandBuffer cmd, ProfilingSampler? sampler)
        : this(cmd.Wrapped, sampler)
    {
    }

    public ProfilingScope(ProfilingSampler sampler)
        : this((CommandBuffer?)null, sampler)
    {
    }

    public void Dispose() => sampler?.End(buffer);
}
