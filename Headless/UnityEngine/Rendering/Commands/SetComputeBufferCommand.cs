using UnityEngine;

namespace Headless.Engine;

/// <summary>Binds a buffer to a kernel.</summary>
internal sealed class SetComputeBufferCommand(ComputeShader shader, int kernel, int nameId, DeviceBuffer? buffer) : GpuCommand
{
    public override void Run(CommandContext context) => shader.BindBuffer(kernel, nameId, buffer);
}
