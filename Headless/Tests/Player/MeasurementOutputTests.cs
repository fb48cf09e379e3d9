using Headless.Tests.Fuzz;
using NUnit.Framework;

namespace Headless.Tests.Player;

/// <summary>--out of the package's measurements, as a user starts them: what is not theirs stays, and nothing is measured.</summary>
[Category("Gpu")]
public sealed class MeasurementOutputTests
{
    private string folder = "";

    [SetUp]
    public void SetUp() => folder = Directory.CreateTempSubdirectory("measured-").FullName;

    [TearDown]
    public void TearDown() => Directory.Delete(folder, recursive: true);

    [TestCase("SphFluid.Validation.CommandLine.Bench", "solver.csv", "--table", "solver")]
    [TestCase("SphFluid.Validation.CommandLine.Chart", "accuracy.png", "--quick")]
    [TestCase("SphFluid.Validation.CommandLine.Chart", "curves/dam-break.thesis.csv", "--quick")]
    [TestCase("SphFluid.Validation.CommandLine.Stability", "stability-m2.svg", "--quick")]
    [TestCase("SphFluid.Validation.CommandLine.Leaks", "leaks.csv")]
    [TestCase("SphFluid.Validation.CommandLine.Surfaces", "surface-quality.csv", "--quick")]
    [TestCase("SphFluid.Validation.CommandLine.Budgets", "budgets.csv")]
    [TestCase("SphFluid.Validation.Editor.SwitchFigures.Write", "thesis-kernel.png")]
    [TestCase("SphFluid.Validation.Editor.FailureFigures.Write", "failure-pairing.png")]
    public void AFileOfTheUsersIsNamedAndStays(string method, string file, params string[] flags)
    {
        string name = method.EndsWith("SwitchFigures.Write", StringComparison.Ordinal) ? FirstFigure() : file;
        string path = Path.Combine(folder, name);
        Directory.CreateDirectory(Path.GetDirectoryName(path)!);
        File.WriteAllText(path, "years of work");
        PlayerProcess run = Measure(method, folder, flags);
        Assert.That(run.ExitCode, Is.EqualTo(2), run.Output + run.Errors);
        Assert.That(run.Errors.TrimEnd().Split('\n'), Has.Length.EqualTo(1));
        Assert.That(run.Errors, Does.Contain($"--out: '{folder}' holds {name}, which no measurement wrote"));
        Assert.That(File.ReadAllText(path), Is.EqualTo("years of work"));
        Assert.That(Directory.GetFiles(folder, "*", SearchOption.AllDirectories), Is.EqualTo(new[] { path }), "nothing else is written");
    }

    [TestCase("SphFluid.Validation.CommandLine.Bench")]
    [TestCase("SphFluid.Validation.CommandLine.Chart")]
    [TestCase("SphFluid.Validation.CommandLine.Stability")]
    [TestCase("SphFluid.Validation.CommandLine.Leaks")]
    [TestCase("SphFluid.Validation.CommandLine.Surfaces")]
    [TestCase("SphFluid.Validation.CommandLine.Budgets")]
    [TestCase("SphFluid.Validation.Editor.SwitchFigures.Write")]
    [TestCase("SphFluid.Validation.Editor.FailureFigures.Write")]
    [Platform("Linux")]
    public void AFolderThatCannotBeWrittenIsOneLineAndExitCode2(string method)
    {
        PlayerProcess run = Measure(method, "/proc/sphfluid");
        Assert.That(run.ExitCode, Is.EqualTo(2), run.Output + run.Errors);
        Assert.That(run.Errors.TrimEnd().Split('\n'), Has.Length.EqualTo(1));
        Assert.That(run.Errors, Does.Match("^[a-z]+: --out: '/proc/sphfluid' cannot be written: "));
    }

    private static string FirstFigure() => Path.GetFileName(
        Directory.GetFiles(Path.Combine(FuzzProject.Repository, "Packages/com.sphfluid.validation/Documentation~/images"), "thesis-*.png").Order(StringComparer.Ordinal).First());

    private static PlayerProcess Measure(string method, string output, params string[] flags)
    {
        string root = FuzzProject.Repository;
        return PlayerProcess.Run(
        [
            "exec", "--project", root, "--assemblies", Path.Combine(root, "Build/ScriptAssemblies"), "--executeMethod", method, "--", .. flags, "--out", output,
        ]);
    }
}
