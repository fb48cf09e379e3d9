using Headless.Checks;
using Headless.Checks.Documents.Facts;
using NUnit.Framework;

namespace Headless.Tests.Checks.Facts;

/// <summary>Facts that a document marks are compared with their source, and written.</summary>
public sealed class FactCheckTests
{
    private TemporaryPackage package = null!;

    [SetUp]
    public void MakePackage() => package = new TemporaryPackage();

    [TearDown]
    public void RemovePackage() => package.Dispose();

    [TestCase("it has <!--fact:number:seven-->7<!--/--> legs", 0)]
    [TestCase("it has <!--fact:number:seven-->8<!--/--> legs", 1)]
    [TestCase("it has <!--fact:number:nine-->9<!--/--> legs", 1)]
    [TestCase("it has <!--fact:sum:seven-->7<!--/--> legs", 1)]
    [TestCase("it has <!--fact:number:seven-->7 legs", 1)]
    [TestCase("it has 7<!--/--> legs", 1)]
    [TestCase("it has\n<!--fact:number:seven-->7<!--/--> **legs**", 1)]
    [TestCase("<!--fact:number:table-->\n\n| a |\n|---|\n| 1 |\n\n<!--/-->", 0)]
    [TestCase("<!--fact:number:table-->\n\n| a |\n|---|\n| 2 |\n\n<!--/-->", 1)]
    public void WhatDiffersFromItsSourceIsFound(string text, int findings)
    {
        Write(text);
        Assert.That(Check().Run(update: false).Findings, Has.Count.EqualTo(findings));
    }

    [Test]
    public void UpdateWritesWhatIsKnownAndNothingElse()
    {
        Write("a <!--fact:number:seven-->8<!--/-->, <!--fact:number:nine-->9<!--/--> and 8\n\n<!--fact:number:table-->x<!--/-->");
        Assert.That(Check().Run(update: true).Findings, Has.One.Contains("number:nine"));
        Assert.That(Read(), Is.EqualTo("a <!--fact:number:seven-->7<!--/-->, <!--fact:number:nine-->9<!--/--> and 8\n\n<!--fact:number:table-->\n\n| a |\n|---|\n| 1 |\n\n<!--/-->\n"));
    }

    [TestCase("rows", "4")]
    [TestCase("rows:escapes=0", "2")]
    [TestCase("rows:escapes!=0", "2")]
    [TestCase("rows:escapes=0:scene=cup", "1")]
    [TestCase("rows:escapes=1+2", "2")]
    [TestCase("dates", "2026-01-30, 31 and 2026-02-01")]
    [TestCase("device", "llvmpipe (CPU) and Card, large")]
    [TestCase("max:escapes", "2")]
    [TestCase("sum:escapes:scene=cup", "1")]
    [TestCase("table:scene:escapes", "| scene | runs | escapes |\n|---|---|---|\n| cup | 2 | 0 to 1 |\n| box | 2 | 0 to 2 |\n")]
    public void ATableIsAsked(string question, string answer)
    {
        package.Write("../../benchmarks/leaks.csv", "scene,escapes,device,date\ncup,0,llvmpipe (LLVM),2026-01-30\ncup,1,llvmpipe (LLVM),2026-01-31\nbox,0,\"Card, large\",2026-02-01\nbox,2,llvmpipe (LLVM),2026-01-30\n");
        Assert.That(new TableFacts(package.Project).Find(["leaks.csv", .. question.Split(':')]), Is.EqualTo(answer));
    }

    [TestCase("interval", "10")]
    [TestCase("isOn", "on")]
    [TestCase("isOff", "off")]
    [TestCase("unset", "0")]
    [TestCase("share", "0.75")]
    [TestCase("most", "1,048,576")]
    [TestCase("kind", "Wide")]
    public void ADefaultIsWhatTheFieldIsGiven(string field, string value)
    {
        package.Write("Runtime/V.cs", "class Limits { public const int Most = 1 << 20; } class V { int interval = 10; bool isOn = true, isOff; float unset; float share = 0.75f; int most = Limits.Most; Kind kind = Kind.Wide; }");
        Assert.That(new CodeFacts(package.Packages).Default(["V", field]), Is.EqualTo(value));
    }

    [TestCase("Water:restDensity", "1,000")]
    [TestCase("Water:viscosity:e", "1.34·10⁻²")]
    public void AnAssetIsRead(string name, string value)
    {
        package.Write("Runtime/Water.asset", "MonoBehaviour:\n  restDensity: 1000\n  viscosity: 0.0134\n");
        Assert.That(new AssetFacts(package.Packages).Find(name.Split(':')), Is.EqualTo(value));
    }

    [Test]
    public void ANumberThatAFactHasIsNotTyped()
    {
        Write("There are 195 entry points, <!--fact:count:entries-->87<!--/--> entry points; a particle needs 56 bytes more with colliders. A save has 28 bytes a particle. Standard needs 148 bytes per particle.");
        Assert.That(new TypedFactCheck(package.Packages).Run().Findings, Has.Count.EqualTo(3));
    }

    [TestCase("`benchmarks/box-2026-01-02.csv`, 2026-01-02", 0)]
    [TestCase("`benchmarks/box-2026-01-02.csv`, 2026-01-03", 1)]
    [TestCase("it was 2026-01-03. Then `benchmarks/box-2026-01-02.csv`", 0)]
    [TestCase("([table](../benchmarks/box-2026-01-02.csv), box, 2026-01-01)", 1)]
    public void ATableHasTheDaysOfItsRows(string text, int findings)
    {
        package.Write("../../benchmarks/box-2026-01-02.csv", "a,date\n1,2026-01-02\n");
        Write(text);
        Assert.That(new DatedTableCheck(package.Packages).Run().Findings, Has.Count.EqualTo(findings));
    }

    private FactCheck Check() => new(package.Packages, new FactSources(new Dictionary<string, Func<string[], string>>
    {
        ["number"] = words => words[0] switch { "seven" => "7", "table" => "| a |\n|---|\n| 1 |\n", _ => throw new UnknownFactException("no such number") },
    }));

    private void Write(string text) => package.Write("Documentation~/page.md", text + "\n");

    private string Read() => File.ReadAllText(Path.Combine(package.Root, "Documentation~", "page.md"));
}
