using Headless.Checks;
using Headless.Checks.Api;
using Headless.Checks.Documents;
using Headless.Checks.Form;
using NUnit.Framework;

namespace Headless.Tests.Checks;

/// <summary>Projects of several packages: what is the product's, and what may build on it.</summary>
public sealed class ProjectPackagesTests
{
    private TemporaryPackage package = null!;

    [SetUp]
    public void SetUp() => package = new TemporaryPackage()
        .Write("../com.a.tools/package.json", """{ "name": "com.a.tools", "version": "2.0.0", "dependencies": { "com.sphfluid": "1.0.0" } }""")
        .Write("../com.a.tools/Runtime/Tools.asmdef", """{ "name": "Tools", "references": ["A"], "includePlatforms": [], "defineConstraints": [] }""")
        .Write("../com.a.tools/Runtime/Tool.cs", "class Tool { A a = new A(); }")
        .Write("../not-a-package/notes.txt", "");

    [TearDown]
    public void TearDown() => package.Dispose();

    [Test]
    public void TheProductComesFirstAndOtherFoldersAreNone()
    {
        Assert.That(package.Packages.All.Select(p => Path.GetFileName(p)), Is.EqualTo(new[] { "com.sphfluid", "com.a.tools" }));
    }

    [TestCase("com.sphfluid/Shaders/K.compute", "Shaders/K.compute", "Shaders/K.compute")]
    [TestCase("com.a.tools/Runtime/K.compute", "com.a.tools/Runtime/K.compute", "Runtime/K.compute")]
    public void FilesAreNamedByTheirPackage(string file, string name, string inPackage)
    {
        string path = Path.Combine(package.Packages.Folder, file);

        Assert.That((package.Packages.NameOf(path), package.Packages.PathInPackage(path)), Is.EqualTo((name, inPackage)));
    }

    [Test]
    public void OtherPackagesSeeTheProduct()
    {
        package.Write("Runtime/A.cs", "/// <summary>A.</summary>\npublic class A { }");

        Assert.That(new ApiCheck(package.Packages).Run().SelectMany(r => r.Findings), Is.Empty);
    }

    [Test]
    public void TheProductSeesNoOtherPackage()
    {
        package.Write("Runtime/A.asmdef", """{ "name": "A", "references": ["Tools"], "includePlatforms": [], "defineConstraints": [] }""")
            .Write("../com.a.tools/Runtime/Tool.cs", "/// <summary>Tool.</summary>\npublic class Tool { }")
            .Write("Runtime/A.cs", "class A { Tool tool = new Tool(); }");
        var reports = new ApiCheck(package.Packages).Run().Where(r => r.Name.EndsWith("com.sphfluid") && !UnityLine.All.Any(l => l.IsAlpha && r.Name.Contains(l.Name))).ToList();

        Assert.That(reports, Has.Count.EqualTo(2 * UnityLine.All.Count(l => !l.IsAlpha)));
        foreach (var report in reports)
        {
            Assert.That(report.Findings, Has.Some.Contains("A: references Tools"));
            Assert.That(report.Findings, Has.Some.Contains("CS0246"));
        }
    }

    [Test]
    public void APackageSeesOnlyWhatItsManifestNames()
    {
        package.Write("Runtime/A.cs", "/// <summary>A.</summary>\npublic class A { }")
            .Write("../com.b.more/package.json", """{ "name": "com.b.more", "version": "1.0.0", "dependencies": { "com.sphfluid": "1.0.0" } }""")
            .Write("../com.b.more/Runtime/More.asmdef", """{ "name": "More", "references": ["Tools"], "includePlatforms": [], "defineConstraints": [] }""");
        Assert.That(new ApiCheck(package.Packages).Run().SelectMany(r => r.Findings), Has.Some.Contains("More: references Tools"));

        package.Write("../com.b.more/package.json", """{ "name": "com.b.more", "version": "1.0.0", "dependencies": { "com.a.tools": "2.0.0" } }""");
        Assert.That(new ApiCheck(package.Packages).Run().SelectMany(r => r.Findings), Is.Empty);
    }

    [Test]
    public void TheLockHoldsThePackages()
    {
        package.Write("package.json", """{ "name": "com.sphfluid", "version": "1.1.0" }""")
            .Write("../packages-lock.json", """{ "dependencies": { "com.a.tools": { "version": "file:com.a.tools", "dependencies": {} } } }""");
        var findings = new ProjectSettingsCheck(package.Packages).Run().Findings;

        Assert.That(findings, Has.Some.Contains("packages-lock.json does not have com.sphfluid as file:com.sphfluid"));
        Assert.That(findings, Has.Some.Contains("com.a.tools/package.json asks for com.sphfluid 1.0.0, the project has 1.1.0"));
        Assert.That(findings, Has.Some.Contains("other dependencies of com.a.tools than its package.json"));
    }

    [Test]
    public void DocumentsLeadSomewhere()
    {
        package.Write("Documentation~/index.md", "[a](a.md) [b](../../com.a.tools/Documentation~/b.md#part-two-2)")
            .Write("Documentation~/a.md", "# A\n[gone](gone.md) [part](#no-part) [web](https://example.org/x.md)\n```\n[code](nowhere.md)\n```")
            .Write("Documentation~/unlisted.md", "# U")
            .Write("../com.a.tools/Documentation~/b.md", "# B\n## Part Two (2)\n");

        Assert.That(new LinkCheck(package.Packages).Run().Findings, Is.EqualTo(new[]
        {
            "Packages/com.sphfluid/Documentation~/a.md: the link to 'gone.md' leads nowhere",
            "Packages/com.sphfluid/Documentation~/a.md: the link to '#no-part' names no heading of that page",
            "Packages/com.sphfluid/Documentation~/index.md does not list unlisted.md",
        }));
    }
}
