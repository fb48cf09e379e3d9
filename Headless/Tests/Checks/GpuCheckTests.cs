using Headless.Checks;
using Headless.Checks.Gpu;
using NUnit.Framework;

namespace Headless.Tests.Checks;

/// <summary>RADV compiles a small package; the tables are in a folder of the test's own.</summary>
public sealed class GpuCheckTests
{
    // Every kernel that the check asks a loop of; that of StandardDensity is the test's own.
    private static readonly string Kernels = string.Concat(HotLoop.All.Select(hot => $"#pragma kernel {hot.Kernel}\n")) + """
        StructuredBuffer<float> In; RWStructuredBuffer<float> Out; uint Count;
        float Sum(uint id) { float sum = 0; for (uint i = 0; i < Count; i++) sum += sqrt(In[id + i]); return sum; }

        """ + string.Concat(HotLoop.All.Where(hot => hot.Kernel != "StandardDensity").Select(hot =>
            $"[numthreads(64,1,1)] void {hot.Kernel}(uint3 id : SV_DispatchThreadID) {{ Out[id.x] = Sum(id.x); }}\n"));

    private const string Plain = "[numthreads(64,1,1)] void StandardDensity(uint3 id : SV_DispatchThreadID) { Out[id.x] = Sum(id.x); }";

    // Each is a process of its own, and a run compiles for all of them.
    private const int Families = 2;

    private TemporaryPackage package = null!;
    private Dictionary<string, string>? written;

    [SetUp]
    public void Make() => package = new TemporaryPackage();

    [TearDown]
    public void Delete() => package.Dispose();

    [Test]
    public void ATableThatWasJustWrittenPassesAndAnotherMesaIsSkipped()
    {
        WritePlainAndItsTables();
        Assert.That(Run(families: Families).Select(r => r.Passed), Is.Not.Empty.And.All.True);

        foreach (string file in Directory.GetFiles(Tables)) File.WriteAllText(file, File.ReadAllText(file).Replace("# Mesa ", "# Mesa 1."));
        Assert.That(Run().Select(r => r.SkippedBecause), Has.All.Contains("the tables are of Mesa 1."));
    }

    [TestCase("""
        [numthreads(64,1,1)] void StandardDensity(uint3 id : SV_DispatchThreadID)
        {
            float a[96];
            for (uint i = 0; i < 96; i++) a[i] = In[id.x * 96 + i];
            for (uint k = 0; k < Count; k++) a[(uint)In[k]] += Sum(k);
            Out[id.x] = a[Count];
        }
        """, "scratch_bytes 0 -> ", TestName = "an array with a dynamic index")]
    [TestCase("""
        groupshared float shared_[2048];
        [numthreads(64,1,1)] void StandardDensity(uint3 id : SV_DispatchThreadID)
        {
            shared_[id.x % 2048] = Sum(id.x);
            GroupMemoryBarrierWithGroupSync();
            Out[id.x] = shared_[(id.x + Count) % 2048];
        }
        """, "waves ", TestName = "groupshared memory that leaves fewer waves")]
    public void AKernelThatGotWorseFails(string kernel, string finding)
    {
        WritePlainAndItsTables();
        Write(kernel);

        Assert.That(Run().Select(r => r.Findings), Has.All.Some.Contains(finding));
    }

    [Test]
    public void AKernelMoreAndAKernelLessFail()
    {
        WritePlainAndItsTables();
        foreach (string file in Directory.GetFiles(Tables)) File.WriteAllText(file, File.ReadAllText(file).Replace("StandardDensity", "Gone"));

        List<List<string>> findings = [.. Run().Select(r => r.Findings)];
        Assert.That(findings, Has.All.Some.Contains("Shaders/A.compute StandardDensity Compute Shader: not in the table"));
        Assert.That(findings, Has.All.Some.Contains("Shaders/A.compute Gone Compute Shader: in the table, but not compiled"));
    }

    [Test]
    public void AHotKernelThatIsGoneFails()
    {
        package.Write("Shaders/K.compute", "#pragma kernel K\nRWStructuredBuffer<float> Out; [numthreads(1,1,1)] void K() { Out[0] = 1; }");

        Assert.That(Run(update: true).Single().Findings, Has.Some.Contains("no kernel 'StandardDensity'"));
    }

    [Test]
    public void AnAbortBeforeTheFirstKernelIsAFamilyThatMesaDoesNotKnow()
    {
        FamilyResult result = FamilyResult.Read(GpuFamily.All[0], [], 134, "Unknown GPU family");

        Assert.That(result.SkippedBecause, Does.Contain("NAVI21"));
    }

    [Test]
    public void AnAbortAtAKernelNamesTheKernel()
    {
        FamilyResult result = FamilyResult.Read(GpuFamily.All[0], ["driver radv Mesa 22.3.6", "begin Shaders/A.compute A"], 134, "assertion");

        Assert.That(result.SkippedBecause, Is.Null);
        Assert.That(result.Problems.Single(), Does.Contain("134 at Shaders/A.compute A"));
    }

    private void WritePlainAndItsTables()
    {
        Write(Plain);
        if (written is null)
        {
            Assert.That(Run(update: true, Families).Single().Passed);
            written = Directory.GetFiles(Tables).ToDictionary(f => Path.GetFileName(f)!, File.ReadAllText);
        }
        Directory.CreateDirectory(Tables);
        foreach ((string name, string text) in written) File.WriteAllText(Path.Combine(Tables, name), text);
    }

    private string Tables => Path.Combine(package.Project, "tables");

    private void Write(string kernel) => package.Write("Shaders/A.compute", Kernels + kernel);

    private List<CheckReport> Run(bool update = false, int families = 1)
    {
        var reports = new GpuCheck(package.Packages, Path.Combine(package.Project, "cache"), Tables, [.. GpuFamily.All.Take(families)]).Run(update).ToList();
        if (update && reports[0].SkippedBecause is { } reason) Assert.Ignore(reason);
        return reports;
    }
}
