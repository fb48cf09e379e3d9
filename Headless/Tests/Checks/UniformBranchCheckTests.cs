using Headless.Checks.Shaders;
using NUnit.Framework;

namespace Headless.Tests.Checks;

/// <summary>Branches and ends of loops that hang on uniforms alone, in kernels written for it.</summary>
public sealed class UniformBranchCheckTests
{
    private static readonly string cache = Directory.CreateTempSubdirectory("uniform").FullName;

    [OneTimeTearDown]
    public void RemoveCache() => Directory.Delete(cache, recursive: true);

    [TestCase("if (_Count > 3u) { for (uint i = id.x; i < 64u; i++) _Data[i] = i; }", "a branch hangs on _Count alone, A.compute(7)")]
    [TestCase("for (uint i = 0u; i < _Count; i++) _Data[i] += id.x;", "the end of a loop hangs on _Count alone, A.compute(7)")]
    [TestCase("if (_Count * _Other + 1u > 3u) { for (uint i = id.x; i < 64u; i++) _Data[i] = i; }", "a branch hangs on _Count _Other alone, A.compute(7)")]
    public void IsFoundWithItsLine(string code, string expected) => Assert.That(Findings(code), Has.Some.EndsWith(expected));

    [TestCase("if (id.x < _Count) _Data[id.x] = 1u;")]
    [TestCase("if (_Count & (_Data[0] | 1u)) { for (uint i = id.x; i < 64u; i++) _Data[i] = i; }")]
    [TestCase("for (uint i = 0u; i < 16u; i++) _Data[i] += id.x;")]
    [TestCase("for (uint i = 0u; i < _Data[0]; i++) _Data[i] += _Count;")]
    [TestCase("const uint count = min(_Count, _Data[1] | 0x7FFFFFFFu); for (uint i = 0u; i < count; i++) _Data[i] += id.x;")]
    public void WithAnotherValueItIsNone(string code) => Assert.That(Findings(code).Where(f => f.Contains("hangs on")), Is.Empty);

    private static List<string> Findings(string code)
    {
        using var package = new TemporaryPackage();
        package.Write("Shaders/A.compute", $$"""
            #pragma kernel Test
            RWStructuredBuffer<uint> _Data;
            uint _Count, _Other;
            [numthreads(64, 1, 1)]
            void Test(uint3 id : SV_DispatchThreadID)
            {
                {{code}}
            }
            """);
        var report = new UniformBranchCheck(package.Packages, cache).Run();
        if (report.SkippedBecause is { } reason) Assert.Ignore(reason);
        return report.Findings;
    }
}
