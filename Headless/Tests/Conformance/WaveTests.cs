using NUnit.Framework;
using UnityEngine;

namespace Headless.Tests.Conformance;

public sealed class WaveTests : HlslFixture
{
    private const string Prefix = """
        [numthreads(4, 1, 1)] void Main(uint t : SV_GroupIndex)
        {
            float own = t + 2.0;
            _Result[t] = WavePrefixSum(own);
            _Result[t + 4] = WavePrefixProduct(own);
            _Result[t + 8] = WavePrefixCountBits(t != 1);
            _Result[t + 12] = WaveActiveSum(own);
        }
        """;

    [TestCase("WavePrefixSum(_Result[1])")]
    [TestCase("WaveActiveMax(_Result[1])")]
    [TestCase("WaveReadLaneFirst(_Result[1])")]
    [TestCase("QuadReadAcrossX(_Result[1])")]
    public void WaveOperationsAreUnknownToDirect3D11(string call)
    {
        ComputeShader shader = Compute($"#pragma kernel Main\nRWStructuredBuffer<float> _Result;\n\n[numthreads(1, 1, 1)] void Main()\n{{\n    _Result[0] = {call};\n}}\n");
        Assert.That(shader.IsSupported(0), Is.False);
        string error = TakeErrors().Single();
        Assert.That(error, Does.Contain($"undeclared identifier '{call[..call.IndexOf('(')]}'").And.Contain(".compute(6)"));
    }

    [Test]
    public void AWaveOperationThatIsNotCompiledIsNoError() =>
        Gives([4], "#ifdef SHADER_API_D3D12\nfloat Sum(float x) { return WaveActiveSum(x); }\n#else\nfloat Sum(float x) { return x * 4; }\n#endif", "_Result[0] = Sum(1);");

    /// <summary>Whole waves are 4 lanes or more on every device, so a group of 4 is one wave.</summary>
    [Test]
    public void PrefixesLeaveTheLanesOwnValueOut()
    {
        float[] found = RunKernel("#pragma use_dxc\n" + Prefix, 16);
        Assert.That(found[..4], Is.EqualTo(new float[] { 0, 2, 5, 9 }));
        Assert.That(found[4..8], Is.EqualTo(new float[] { 1, 2, 6, 24 }));
        Assert.That(found[8..12], Is.EqualTo(new float[] { 0, 1, 1, 2 }));
        Assert.That(found[12..], Is.EqualTo(new float[] { 14, 14, 14, 14 }));
    }
}
