using Headless.Checks;
using Headless.Checks.Dxc;
using NUnit.Framework;

namespace Headless.Tests.Checks;

public sealed class DxcCheckTests
{
    private static readonly string cache = Headless.Files.UserCache.Folder;

    [Test]
    public void AGoodKernelPasses()
    {
        CheckReport report = Run("Out[id.x] = 1;");

        Assert.That(report.Findings, Is.Empty);
        Assert.That(report.Figures, Does.StartWith("1 entry points"));
    }

    [TestCase("Out[id.x] = nothing;", "undeclared identifier", TestName = "an error for DXC")]
    [TestCase("float2 v = float3(1, 2, 3); Out[id.x] = v.x;", "truncation", TestName = "a warning of DXC")]
    public void FaultsAreFound(string body, string message) => Assert.That(Run(body).Findings, Has.Some.Contains(message).IgnoreCase);

    private static CheckReport Run(string body)
    {
        using var package = new TemporaryPackage().Write("Shaders/K.compute", $$"""
            #pragma kernel K
            RWStructuredBuffer<float> Out; [numthreads(64,1,1)] void K(uint3 id : SV_DispatchThreadID) { {{body}} }
            """);
        CheckReport report = new DxcCheck(package.Packages, cache).Run();
        if (report.SkippedBecause is { } reason) Assert.Ignore(reason);
        return report;
    }
}
