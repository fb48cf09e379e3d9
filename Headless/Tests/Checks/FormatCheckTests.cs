using Headless.Checks.Format;
using NUnit.Framework;

namespace Headless.Tests.Checks;

public sealed class FormatCheckTests
{
    private const string Rules = "root = true\n[*.cs]\nindent_style = space\nindent_size = 4\nend_of_line = lf\n";

    [Test]
    public void CodeIsHeldAgainstTheRules()
    {
        using var package = new TemporaryPackage().Write("../../.editorconfig", Rules)
            .Write("Runtime/Good.cs", "class A\n{\n    int b;\n}\n")
            .Write("Runtime/Indented.cs", "class B\n{\n  int b;\n}\n")
            .Write("Runtime/Braced.cs", "class C {\n    int b;\n}\n");

        var report = new CodeFormatCheck(package.Project).Run();

        Assert.That(report.SkippedBecause, Is.Null);
        Assert.That(report.Findings, Has.Count.EqualTo(2).And.Some.Contains("Runtime/Indented.cs, line 3: ").And.Some.Contains("Runtime/Braced.cs, line 1: "));
        Assert.That(report.Figures, Is.EqualTo("3 files"));
    }

    [TestCase("float a;\n")]
    [TestCase("")]
    [TestCase("\tfloat a;\n", "line 1 has a tab")]
    [TestCase("float a;\nfloat b; \n", "line 2 ends with a blank")]
    [TestCase("float a;\r\n", "line 1 ends with a carriage return")]
    [TestCase("float a;", "the last line has no end")]
    public void TextIsHeldAgainstTheRules(string text, params string[] faults)
    {
        using var package = new TemporaryPackage().Write("Shaders/A.hlsl", text);

        Assert.That(new TextFormatCheck(package.Project).Run().Findings, Is.EqualTo(faults.Select(f => $"Packages/com.sphfluid/Shaders/A.hlsl: {f}")));
    }
}
