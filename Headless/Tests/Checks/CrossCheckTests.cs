using Headless.Checks;
using Headless.Checks.Cross;
using NUnit.Framework;

namespace Headless.Tests.Checks;

public sealed class CrossCheckTests
{
    [Test]
    public void AKernelWithD3DsPackingIsTranslated()
    {
        CheckReport[] reports = Run("struct S { float3 a; float3 b; }; RWStructuredBuffer<S> Out; [numthreads(64,1,1)] void K(uint3 id : SV_DispatchThreadID) { Out[id.x].b = 1; }");

        Assert.That(reports.SelectMany(r => r.Findings.Concat(r.Notes)), Is.Empty);
        Assert.That(reports.Select(r => r.Figures), Has.All.StartsWith("1 kernels and variants translated"));
    }

    [Test]
    public void DoublesAreFoundThatNeitherLanguageHas()
    {
        CheckReport[] reports = Run("RWStructuredBuffer<float> Out; [numthreads(64,1,1)] void K(uint3 id : SV_DispatchThreadID) { double d = Out[id.y]; Out[id.x] = (float)(d * d); }");

        Assert.That(reports.Select(r => r.Findings.Count), Has.All.EqualTo(1));
    }

    [Test]
    public void MoreBuffersThanEveryDeviceHasAreNoted()
    {
        string source = string.Concat(Enumerable.Range(0, 5).Select(i => $"RWStructuredBuffer<float> B{i}; "))
            + "[numthreads(256,1,1)] void K(uint3 id : SV_DispatchThreadID) { " + string.Concat(Enumerable.Range(0, 5).Select(i => $"B{i}[id.x] = 1; ")) + "}";
        CheckReport[] reports = Run(source);

        Assert.That(reports.Select(r => r.Passed), Has.All.True);
        Assert.That(reports[0].Notes, Is.Empty);
        Assert.That(reports[1].Notes, Is.EqualTo(new[] { "Shaders/K.compute K: 5 storage buffers, every device has 4" }));
        Assert.That(reports[1].Figures, Does.EndWith("; 1 have more than 4 storage buffers; 1 have more than 128 threads a group"));
    }

    private static CheckReport[] Run(string source)
    {
        using var package = new TemporaryPackage().Write("Shaders/K.compute", "#pragma kernel K\n" + source);
        CheckReport[] reports = [.. new CrossCheck(package.Packages, Path.Combine(package.Project, "cache")).Run()];
        if (reports[0].SkippedBecause is { } reason) Assert.Ignore(reason);
        return reports;
    }
}
