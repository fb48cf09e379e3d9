using Headless.Tests.Rendering;
using NUnit.Framework;
using UnityEngine;

namespace Headless.Tests.Conformance;

/// <summary>Runs a kernel "Main" of one group that writes floats into _Result.</summary>
public abstract class HlslFixture : RenderFixture
{
    /// <summary>What the statements of a kernel of one thread leave in _Result.</summary>
    protected float[] Run(string globals, string body, int count, Action<ComputeShader>? set = null) =>
        RunKernel(globals + "\n[numthreads(1, 1, 1)] void Main() { " + body + " }", count, set);

    /// <summary>What the kernel Main leaves in _Result; one group is run.</summary>
    protected float[] RunKernel(string source, int count, Action<ComputeShader>? set = null)
    {
        ComputeShader shader = Compute("#pragma kernel Main\nRWStructuredBuffer<float> _Result;\n" + source);
        using GraphicsBuffer result = Floats(new float[count]);
        shader.SetBuffer(0, "_Result", result);
        set?.Invoke(shader);
        shader.Dispatch(0, 1, 1, 1);
        return Read(result);
    }

    protected void Gives(float[] expected, string globals, string body, Action<ComputeShader>? set = null) =>
        Assert.That(Run(globals, body, expected.Length, set), Is.EqualTo(expected));
}
