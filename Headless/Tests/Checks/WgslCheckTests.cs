using Headless.Checks;
using Headless.Checks.Wgsl;
using Headless.Files;
using NUnit.Framework;

namespace Headless.Tests.Checks;

public sealed class WgslCheckTests
{
    private const string Declared = "struct S { float3 a; float3 b; }; RWStructuredBuffer<S> Out; ";

    [TestCase("Out[id.x].b = 1;", TestName = "D3D's packing")]
    [TestCase("Out[id.x].a = all(id > 2 && id < 9) ? 1 : 0;", TestName = "logic of vectors")]
    public void WhatWgslHasIsTaken(string body)
    {
        CheckReport report = Run(Declared, body);

        Assert.That(report.Findings.Concat(report.Notes), Is.Empty);
        Assert.That(report.Figures, Does.StartWith("1 of 1 stages"));
    }

    [Test]
    public void ABarrierThatSomeThreadsMayMissIsFound() =>
        Assert.That(Run(Declared, "if (Out[0].a.x > 0) GroupMemoryBarrierWithGroupSync(); Out[id.x].b = 1;").Findings, Has.One.Contains("tint"));

    [Test]
    public void MoreBuffersThanEveryDeviceHasAreNoted()
    {
        string buffers = string.Concat(Enumerable.Range(0, 9).Select(i => $"RWStructuredBuffer<float> B{i}; "));
        string body = string.Concat(Enumerable.Range(0, 9).Select(i => $"B{i}[id.x] = 1; "));

        CheckReport report = Run(buffers, body);

        Assert.That(report.Passed);
        Assert.That(report.Notes, Has.One.Contains("storage buffers (9)"));
    }

    private static CheckReport Run(string declared, string body)
    {
        using var package = new TemporaryPackage().Write("Shaders/K.compute",
            $"#pragma kernel K\n{declared}\n[numthreads(64,1,1)] void K(uint3 id : SV_DispatchThreadID) {{ {body} }}");
        CheckReport report = new WgslCheck(package.Packages, Path.Combine(package.Project, "cache"), UserCache.Folder).Run();
        if (report.SkippedBecause is { } reason) Assert.Ignore(reason);
        return report;
    }
}
