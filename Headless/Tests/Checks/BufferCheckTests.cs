using Headless.Checks;
using Headless.Checks.Buffers;
using NUnit.Framework;

namespace Headless.Tests.Checks;

public sealed class BufferCheckTests
{
    private const string Page = "# P\n\n| Part | Storage buffers | of them written | In |\n| --- | --- | --- | --- |\n\nend\n";

    private TemporaryPackage package = null!;

    [SetUp]
    public void Make() => package = new TemporaryPackage().Write("Documentation~/platforms.md", Page);

    [TearDown]
    public void Delete() => package.Dispose();

    [Test]
    public void OnlyBuffersThatTheCodeUsesCount()
    {
        Write("StructuredBuffer<float> In; StructuredBuffer<float> Unused; RWStructuredBuffer<float> Out;", "Out[id.x] = In[id.x];");
        Assert.That(Run(update: true).Findings, Is.Empty);

        Assert.That(File.ReadAllText(Path.Combine(package.Root, "Documentation~/platforms.md")),
            Does.Contain("| measurements of the validation package | 2 | 1 | K |\n\nend"));
        Assert.That(Run(update: false).Passed);
    }

    [Test]
    public void AKernelBeyondItsNumberIsFound()
    {
        Write("RWStructuredBuffer<float> Out;", "Out[id.x] = 1;");
        Run(update: true);
        Write("ByteAddressBuffer In; RWStructuredBuffer<float> Out;", "Out[id.x] = In.Load(4);");

        Assert.That(Run(update: false).Findings, Has.Some.EqualTo("Shaders/K.compute K compute: buffers 1 -> 2"));
    }

    private void Write(string buffers, string body) => package.Write("Shaders/K.compute",
        $"#pragma kernel K\n{buffers}\n[numthreads(64,1,1)] void K(uint3 id : SV_DispatchThreadID) {{ {body} }}");

    private CheckReport Run(bool update)
    {
        var check = new BufferCheck(package.Packages, Path.Combine(package.Project, "cache"), Path.Combine(package.Project, "tables"));
        CheckReport report = check.Run(update);
        if (report.SkippedBecause is { } reason) Assert.Ignore(reason);
        return report;
    }
}
