using UnityEngine;

namespace Headless.Engine;

/// <summary>Sets an array or matrix under a name of a compute shader.</summary>
internal sealed class SetComputeBytesCommand(ComputeShader shader, int nameId, byte[] bytes) : GpuCommand
{
    public override void Run(CommandContext context) => shader.Program.State.Set(nameId, bytes);
}
