using Headless.Checks.Fxc;
using Headless.Shaders;
using NUnit.Framework;

namespace Headless.Tests.Checks;

public sealed class FxcCheckTests
{
    private static readonly string cache = Path.Combine(
        Environment.GetEnvironmentVariable("XDG_CACHE_HOME") is { Length: > 0 } home ? home : Path.Combine(Environment.GetFolderPath(Environment.SpecialFolder.UserProfile), ".cache"), "sphfluid");

    [Test]
    public void VariantsAreTheProductOfTheSets()
    {
        KeywordSet[] sets = [new(["", "A"], true, false), new(["B", "C"], true, false)];

        Assert.That(FxcJob.Variants(sets).Select(v => string.Join(' ', v)), Is.EquivalentTo(new[] { "B", "C", "A B", "A C" }));
    }

    [Test]
    public void AGoodKernelPasses()
    {
        var report = Run("RWStructuredBuffer<float> Out; [numthreads(64,1,1)] void K(uint3 id : SV_DispatchThreadID) { Out[id.x] = 1; }");

        Assert.That(report.Findings, Is.Empty);
        Assert.That(report.Figures, Does.StartWith("1 entry points"));
    }

    [TestCase("[numthreads(64,1,1)] void K(uint3 id : SV_DispatchThreadID) { Out[id.x] = nothing; }", "undeclared identifier", TestName = "an error")]
    [TestCase("[numthreads(64,1,1)] void K(uint3 id : SV_DispatchThreadID) { float2 v = float3(1,2,3); Out[id.x] = v.x; }", "truncation", TestName = "a warning")]
    [TestCase("groupshared float s[9000]; [numthreads(64,1,1)] void K(uint3 id : SV_DispatchThreadID) { s[id.x] = 1; Out[id.x] = s[id.y]; }", "32768", TestName = "too much groupshared memory")]
    public void FaultsAreFound(string source, string message)
    {
        var findings = Run("RWStructuredBuffer<float> Out;\n" + source).Findings;

        Assert.That(findings, Has.Some.Contains(message).IgnoreCase);
    }

    private static Headless.Checks.CheckReport Run(string source)
    {
        using var package = new TemporaryPackage().Write("Shaders/K.compute", "#pragma kernel K\n" + source);
        var report = new FxcCheck(package.Project, package.Root, cache).Run();
        if (report.SkippedBecause is { } reason) Assert.Ignore(reason);
        return report;
    }
}
