using System.Runtime.InteropServices;
using System;
using UnityEngine;

namespace Headless.Engine;

/// <summary>Sets a value of at most four words under a name of a compute shader.</summary>
internal sealed class SetComputeValueCommand(ComputeShader shader, int nameId, Vector4 words, int length) : GpuCommand
{
    private readonly Vector4 words = words;

    public override void Run(CommandContext context) =>
        shader.Program.State.Set(nameId, MemoryMarshal.AsBytes(new ReadOnlySpan<Vector4>(in words))[..length]);
}
