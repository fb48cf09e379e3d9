using System;
using Unity.Profiling;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>A sample of the profiler around what is recorded while it lives.</summary>
    internal readonly struct CommandSample : IDisposable
    {
        private readonly CommandBuffer cmd;
        private readonly ProfilerMarker marker;

        public CommandSample(CommandBuffer cmd, in ProfilerMarker marker)
        {
            this.cmd = cmd;
            this.marker = marker;
            cmd.BeginSample(marker);
        }

        public void Dispose() => cmd.EndSample(marker);
    }
}
