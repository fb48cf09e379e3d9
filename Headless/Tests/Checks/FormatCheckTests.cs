using Headless.Checks.Format;
using NUnit.Framework;

namespace Headless.Tests.Checks;

public sealed class FormatCheckTests
{
    private const string Rules = "root = true\n[*.cs]\nindent_style = space\nindent_size = 4\nend_of_line = lf\n";

    [TestCase("class A\n{\n    int b;\n}\n", 0)]
    [TestCase("class A\n{\n  int b;\n}\n", 1)]
    [TestCase("class A {\n    int b;\n}\n", 1)]
    public void CodeIsHeldAgainstTheRules(string code, int findings)
    {
        using var package = new TemporaryPackage().Write("Runtime/A.cs", code).Write("../../.editorconfig", Rules);

        var report = new CodeFormatCheck(package.Project).Run();

        Assert.That(report.SkippedBecause, Is.Null);
        Assert.That(report.Findings, Has.Count.EqualTo(findings).And.All.Contains("Runtime/A.cs, line "));
        Assert.That(report.Figures, Is.EqualTo("1 files"));
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
