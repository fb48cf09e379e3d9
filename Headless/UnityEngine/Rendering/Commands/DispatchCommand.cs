using UnityEngine;

namespace Headless.Engine;

/// <summary>Runs a kernel with what is bound by then.</summary>
internal sealed class DispatchCommand(ComputeShader shader, int kernel, int x, int y, int z) : GpuCommand
{
    public override void Run(CommandContext context)
    {
        if (shader != null)
        {
            ComputeDispatcher.Dispatch(shader, kernel, x, y, z);
        }
    }
}
