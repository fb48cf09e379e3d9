using Headless.Checks.Format;
using NUnit.Framework;

namespace Headless.Tests.Checks;

public sealed class FormatCheckTests
{
    private const string Rules = "root = true\n[*.cs]\nindent_style = space\nindent_size = 4\nend_of_line = lf\nmax_line_length = 60\n";

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
    [TestCase("// 3456789 123456789 123456789 123456789 123456789 123456789\n")]
    [TestCase("// 3456789 123456789 123456789 123456789 123456789 1234567891\n", "line 1 has 61 columns")]
    public void TextIsHeldAgainstTheRules(string text, params string[] faults)
    {
        using var package = new TemporaryPackage().Write("../../.editorconfig", Rules).Write("Shaders/A.hlsl", text);

        Assert.That(new TextFormatCheck(package.Project).Run().Findings, Is.EqualTo(faults.Select(f => $"Packages/com.sphfluid/Shaders/A.hlsl: {f}")));
    }

    [TestCase("internal class A { }")]
    [TestCase("class A { }", "the access modifier is left out")]
    [TestCase("public interface I { int A { get; } }")]
    [TestCase("public enum E { A }")]
    [TestCase("public class A { int b; }", "the access modifier is left out")]
    [TestCase("public class A { A() { } static A() { } ~A() { } }", "the access modifier is left out")]
    [TestCase("public class A { int I.C() => 1; partial void D(); }")]
    [TestCase("public class A { class B { } delegate void C(); event D E; }", "the access modifier is left out")]
    [TestCase("#if X\npublic class A { int b; }\n#else\npublic class A { }\n#endif", "the access modifier is left out")]
    [TestCase("#if X\npublic class A { }\n#else\npublic class A { int b; }\n#endif", "the access modifier is left out")]
    public void AccessModifiersAreWritten(string text, params string[] faults) => Assert.That(Faults(text), Is.EqualTo(faults));

    [TestCase("if (a) b();")]
    [TestCase("if (a)\n        b();", Joined)]
    [TestCase("if (a)\n    {\n        b();\n    }", Joined)]
    [TestCase("if (a) { b(); }", Joined)]
    [TestCase("if (a) b(); // why")]
    [TestCase("if (a)\n        b(); // why", Joined)]
    [TestCase("if (a)\n    {\n        // why\n        b();\n    }")]
    [TestCase("if (a)\n        // why\n        b();")]
    [TestCase("if (a)\n    {\n        b();\n        c();\n    }")]
    [TestCase("if (a)\n    {\n        b();\n    }\n    else c();")]
    [TestCase("if (a) if (b) c(); else d();")]
    [TestCase("for (;;)\n        b();", Joined)]
    [TestCase("foreach (var x in y)\n        b();", Joined)]
    [TestCase("while (a)\n        return;", Joined)]
    [TestCase("foreach (var x in y)\n        if (x) b();")]
    [TestCase("foreach (var x in y)\n        if (x)\n            b();", Joined)]
    [TestCase("if (a)\n        throw new System.Exception(123456789, 123456789012);", Braces)]
    [TestCase("if (a)\n    {\n        throw new System.Exception(123456789, 123456789012);\n    }")]
    [TestCase("if (a &&\n        b) c();", Braces)]
    [TestCase("if (a) b(1,\n        2);", Braces)]
    public void ShortStatementsHaveOneForm(string statement, params string[] faults) =>
        Assert.That(Faults("public class A\n{\n    public void B()\n    {\n    " + statement + "\n    }\n}\n"), Is.EqualTo(faults));

    [TestCase("public class A { } // 89 123456789 123456789 123456789 12345")]
    [TestCase("public class A { } // 89 123456789 123456789 123456789 123451", "61 columns")]
    [TestCase("public class A { public string b = @\"\n3456789 123456789 123456789 123456789 123456789 123456789 1234\n\"; }")]
    public void LinesOfCodeAreShort(string text, params string[] faults) => Assert.That(Faults(text), Is.EqualTo(faults));

    private const string Joined = "a short statement that fits on one line", Braces = "a statement on a line of its own has braces";

    private static IEnumerable<string> Faults(string text) => CodeStyleCheck.Faults(text, 60).Select(f => f.Text);
}
