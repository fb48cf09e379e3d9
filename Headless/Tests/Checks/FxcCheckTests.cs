using Headless.Checks.Fxc;
using Headless.Shaders;
using Headless.Shaders.Direct3D;
using NUnit.Framework;

namespace Headless.Tests.Checks;

public sealed class FxcCheckTests
{
    private static readonly string cache = Headless.Files.UserCache.Folder;

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
    [TestCase("groupshared float s[5000]; [numthreads(64,1,1)] void K(uint3 id : SV_DispatchThreadID) { s[id.x] = 1; Out[id.x] = s[id.y]; }", "20000 bytes of groupshared", TestName = "more groupshared memory than is promised")]
    public void FaultsAreFound(string source, string message)
    {
        var findings = Run("RWStructuredBuffer<float> Out;\n" + source).Findings;

        Assert.That(findings, Has.Some.Contains(message).IgnoreCase);
    }

    [Test]
    public void WhatWasCompiledWithoutAMessageIsKnownByItsText()
    {
        var toolchain = new WineToolchain(WineDriver.Fxc, cache);
        if (toolchain.Prepare() is { } reason) Assert.Ignore(reason);
        string folder = Directory.CreateTempSubdirectory("known-").FullName, known = Path.Combine(cache, "fxc", "known");
        string fresh = $"// {Guid.NewGuid()}\n#line 1 \"{folder}/A.hlsl\"\nRWStructuredBuffer<float> Out; [numthreads(64,1,1)] void K(uint3 id : SV_DispatchThreadID) ";
        File.WriteAllText(Path.Combine(folder, "0.hlsl"), fresh + "{ Out[id.x] = 1; }");
        File.WriteAllText(Path.Combine(folder, "1.hlsl"), fresh + "{ float2 v = float3(1, 2, 3); Out[id.x] = v.x; }");
        string[] jobs = ["0\t0.hlsl\tK\tcs_5_0", "1\t1.hlsl\tK\tcs_5_0"];
        DateTime start = DateTime.UtcNow.AddSeconds(-2);
        List<string> first = toolchain.Run(folder, jobs);

        string[] made = [.. Directory.GetFiles(known).Where(f => File.GetLastWriteTimeUtc(f) > start && "0\t" + File.ReadAllText(f) == first[0].TrimEnd())];
        Assert.That(made, Is.Not.Empty);
        foreach (string file in made) File.WriteAllText(file, "ok\t1\t0\t64\t77\t\t1\t0");
        File.WriteAllText(Path.Combine(folder, "0.hlsl"), (fresh + "{ Out[id.x] = 1; }").Replace("A.hlsl", "B.hlsl"));
        List<string> again = toolchain.Run(folder, jobs);
        Assert.That(again, Has.One.EqualTo("0\tok\t1\t0\t64\t77\t\t1\t0").And.One.Contains("truncation"));
        File.WriteAllText(Path.Combine(folder, "0.hlsl"), fresh + "{ Out[id.x] = 2; }");
        Assert.That(toolchain.Run(folder, jobs), Has.None.Contains("\t77\t"), "another text");

        foreach (string file in made) File.Delete(file);
        Directory.Delete(folder, recursive: true);
    }

    [Test]
    public void TooManyComputeVariantsAreFound()
    {
        var keywords = string.Concat(Enumerable.Range(0, 8).Select(i => $"#pragma multi_compile_local _ A{i}\n"));
        var report = Run(keywords + "RWStructuredBuffer<float> Out; [numthreads(1,1,1)] void K() { Out[0] = 1; }");

        Assert.That(report.Findings, Has.One.Contains("256 compute variants"));
        Assert.That(report.Figures, Does.Contain("256 compute variants").And.Contains("1 buffers"));
    }

    [Test]
    public void StatedNeedsAreHeldAgainstTheListings()
    {
        const string kernel = "RWStructuredBuffer<float> Out; RWByteAddressBuffer Words; StructuredBuffer<float> In; groupshared float s[64];"
            + "[numthreads(64,1,1)] void K(uint3 id : SV_DispatchThreadID) { s[id.x] = In[id.x]; Out[id.x] = s[63u - id.x]; Words.Store(4u * id.x, 1u); }";

        Assert.That(Run(kernel, Needs(64, 3, 2, 256)).Findings, Is.Empty);
        Assert.That(Run(kernel, Needs(64, 2, 2, 256)).Findings, Has.One.Contains("64 threads, 3 buffers, 2 written, 256 bytes shared"));
        Assert.That(Run(kernel, "nothing").Findings, Has.One.Contains("no shader group"));
    }

    [Test]
    public void VariantsOfOptionalPhysicsCountForTheirOwnGroup()
    {
        const string kernel = "#pragma multi_compile_local _ MORE\nRWStructuredBuffer<float> Out;\n#if defined(MORE)\nStructuredBuffer<float> In;\n#endif\n"
            + "[numthreads(64,1,1)] void K(uint3 id : SV_DispatchThreadID) {\n#if defined(MORE)\nOut[id.x] = In[id.x];\n#else\nOut[id.x] = 1.0;\n#endif\n}";
        string Optional(int buffers) => Needs(64, buffers, 1, 0).Replace("\"Shaders\"", "\"Shaders/Optional\"") + " { Keyword = \"MORE\" };";

        Assert.That(Run(kernel, Needs(64, 1, 1, 0) + ";" + Optional(2)).Findings, Is.Empty);
        Assert.That(Run(kernel, Needs(64, 2, 1, 0) + ";" + Optional(2)).Findings, Has.One.Contains("1 buffers"));
        Assert.That(Run(kernel, Needs(64, 1, 1, 0) + ";" + Optional(1)).Findings, Has.One.Contains("Shaders/Optional: 64 threads, 1 buffers"));
    }

    [Test]
    public void AResultLineKeepsItsPlaces()
    {
        var job = new FxcJob("K", "K", "cs_5_0", "");
        var result = FxcResult.Parse("0\tok\t2\t256\t64\t45\ta | b \t3\t900\t120\r", [job]);

        Assert.That(result, Is.EqualTo(new FxcResult(job, true, 2, 256, 64, 45, "a | b", 3, 900, 120)));
        Assert.That(FxcResult.Parse("0\tfailed\t0\t0\t0\t0\tcrashed", [job]), Is.EqualTo(new FxcResult(job, false, 0, 0, 0, 0, "crashed", 0, 0, 0)));
    }

    // However long FXC took, which only the machine decides.
    [TestCase(0, 0, 0)]
    [TestCase(1, 0, 1)]
    [TestCase(0, 1, 1)]
    [TestCase(1, 1, 2)]
    public void WhatTakesLongToCompileIsFound(int slotsTooMany, int kilobytesTooMany, int findings)
    {
        var job = new FxcJob("K.compute K", "K", "cs_5_0", "") { File = "/p/Shaders/K.compute" };
        var report = new Headless.Checks.CheckReport("FXC");
        new FxcBudget("/p").Check([new FxcResult(job, true, 1, 0, 64, FxcBudget.MaxSlots + slotsTooMany, "", 1, FxcBudget.MaxKilobytes + kilobytesTooMany, 1_000_000)], report);

        Assert.That(report.Findings, Has.Count.EqualTo(findings).And.All.Contains(" are allowed"));
        Assert.That(report.Notes, Is.Empty);
        Assert.That(report.Figures, Does.Contain("1 compute variants").And.Contains("1000.00 s of CPU time"));
    }

    private static string Needs(int threads, int buffers, int writable, int memory) =>
        $"new ShaderGroup(\"a part\", \"Shaders\",\n  groupThreads: {threads}, buffers: {buffers}, writableBuffers: {writable}, groupMemory: {memory}, vertexBuffers: 0)";

    private static Headless.Checks.CheckReport Run(string source, string? needs = null)
    {
        using var package = new TemporaryPackage().Write("Shaders/K.compute", "#pragma kernel K\n" + source);
        if (needs is not null) package.Write("Runtime/ShaderGroup.cs", needs);
        var report = new FxcCheck(package.Packages, cache).Run();
        if (report.SkippedBecause is { } reason) Assert.Ignore(reason);
        return report;
    }
}
