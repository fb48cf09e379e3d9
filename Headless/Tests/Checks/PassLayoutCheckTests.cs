using Headless.Checks.Form;
using NUnit.Framework;

namespace Headless.Tests.Checks;

/// <summary>A pass, its kernels and its tests at mirrored paths.</summary>
public sealed class PassLayoutCheckTests
{
    private const string Pass = "Runtime/Solver/Own/CountPass.cs";
    private const string Kernel = "Shaders/Solver/Own/Count.compute";
    private const string Tests = "Tests/Editor/Solver/Own/CountTests.cs";
    private const string TestText = "public sealed class CountTests { [TestCase(1)] public void ItCounts(int n) { } }";

    private TemporaryPackage package = null!;

    [SetUp]
    public void MakePackage()
    {
        package = new TemporaryPackage();
        package.Write("Runtime/Gpu/ComputePass.cs", "abstract class ComputePass { protected ComputePass(S s, string n) { } }")
            .Write(Pass, PassText("CountPass", "Count"))
            .Write(Kernel, "#pragma kernel Count")
            .Write("Shaders/Solver/Own/Count.hlsl", "")
            .Write(Tests, TestText);
    }

    [TearDown]
    public void RemovePackage() => package.Dispose();

    [Test]
    public void AMirroredPassIsFoundRight()
    {
        var report = new PassLayoutCheck(package.Packages).Run();

        Assert.That(report.Findings, Is.Empty);
        Assert.That(report.Figures, Is.EqualTo("passes with their kernels and tests: 1"));
    }

    [Test]
    public void AMissingKernelIsFound()
    {
        Delete(Kernel);

        Assert.That(Findings(), Is.EqualTo(new[] { $"{Pass}: its kernels are missing, {Kernel}" }));
    }

    [Test]
    public void AMissingTestIsFound()
    {
        Delete(Tests);

        Assert.That(Findings(), Is.EqualTo(new[] { $"{Pass}: its tests are missing, {Tests}" }));
    }

    [Test]
    public void AKernelWithoutAPassIsFound()
    {
        package.Write("Shaders/Surface/Orphan.compute", "#pragma kernel Orphan");

        Assert.That(Findings(), Is.EqualTo(new[]
        {
            "Shaders/Surface/Orphan.compute has no pass: Runtime/Surface/OrphanPass.cs is missing",
        }));
    }

    [Test]
    public void AKernelWhosePassDerivesFromNothingIsFound()
    {
        package.Write(Pass, "sealed class CountPass { }");

        Assert.That(Findings(), Is.EqualTo(new[] { $"{Kernel} has no pass: {Pass} declares no ComputePass" }));
    }

    [Test]
    public void FilesInAnotherFolderAreFoundWithTheirPlace()
    {
        Delete(Kernel);
        Delete(Tests);
        package.Write("Shaders/Count.compute", "#pragma kernel Count").Write("Tests/Editor/CountTests.cs", TestText);

        Assert.That(Findings(), Is.EqualTo(new[]
        {
            $"{Pass}: its kernels belong in {Kernel}, not Shaders/Count.compute",
            $"{Pass}: its tests belong in {Tests}, not Tests/Editor/CountTests.cs",
            "Shaders/Count.compute has no pass: Runtime/CountPass.cs is missing",
        }));
    }

    [TestCase("public sealed class CountTests { public void ItCounts() { } }", TestName = "no test")]
    [TestCase("public sealed class OtherTests { [Test] public void ItCounts() { } }", TestName = "another class")]
    public void AFileWithoutTestsIsFound(string text)
    {
        package.Write(Tests, text);

        Assert.That(Findings(), Is.EqualTo(new[] { $"{Tests} has no class CountTests with a test" }));
    }

    [Test]
    public void APassThatNamesAnotherShaderIsFound()
    {
        package.Write(Pass, PassText("CountPass", "Sum"));

        Assert.That(Findings(), Is.EqualTo(new[] { $"{Pass}: CountPass names the shader 'Sum', not 'Count'" }));
    }

    [TestCase("Runtime/Solver/Own/Two.cs", "AddPass", "the pass AddPass belongs in a file AddPass.cs below Runtime")]
    [TestCase("Editor/AddPass.cs", "AddPass", "the pass AddPass belongs in a file AddPass.cs below Runtime")]
    [TestCase("Runtime/Solver/Own/Add.cs", "Add", "Add is a pass, so its name ends in Pass")]
    public void APassInAFileOfAnotherNameIsFound(string file, string name, string expected)
    {
        package.Write(file, PassText(name, "Add"));

        Assert.That(Findings(), Is.EqualTo(new[] { $"{file}: {expected}" }));
    }

    [Test]
    public void APassThatDerivesByAnAbstractOneCounts()
    {
        package.Write("Runtime/Solver/GridPass.cs", "abstract class GridPass : SphFluid.ComputePass { }")
            .Write("Runtime/Solver/AddPass.cs", "sealed class AddPass : GridPass { }")
            .Write("Shaders/Solver/Add.compute", "#pragma kernel Add");

        Assert.That(Findings(), Is.EqualTo(new[]
        {
            "Runtime/Solver/AddPass.cs: its tests are missing, Tests/Editor/Solver/AddTests.cs",
        }));
    }

    [Test]
    public void PassesOfAnotherPackageCount()
    {
        package.Write("../com.a.tools/package.json", "{}")
            .Write("../com.a.tools/Runtime/AddPass.cs", PassText("AddPass", "Add"))
            .Write("../com.a.tools/Tests/Editor/AddTests.cs", "class AddTests { [Test] public void A() { } }");

        Assert.That(Findings(), Is.EqualTo(new[]
        {
            "com.a.tools/Runtime/AddPass.cs: its kernels are missing, Shaders/Add.compute",
        }));
    }

    private static string PassText(string name, string shader) =>
        $"sealed class {name} : ComputePass {{ public {name}(S s) : base(s, \"{shader}\") {{ }} }}";

    private void Delete(string path) => File.Delete(Path.Combine(package.Root, path));

    private List<string> Findings() => new PassLayoutCheck(package.Packages).Run().Findings;
}
