using Headless.Checks.Documents.Facts;
using NUnit.Framework;
using System.Security.Cryptography;
using System.Text.RegularExpressions;

namespace Headless.Tests.Checks.Facts;

/// <summary>What pages claim of methods, of pictures and on the front page has what shows it.</summary>
public sealed class ClaimChecksTests
{
    private const string Data = "../../Headless/Checks/Documents/Facts/Data/";
    private static readonly Capability emitters = new("ChangingCount", "emitters", new Regex(@"\b[Ee]mitters?\b")), tension = new("SurfaceTension", "surface tension", new Regex(@"\b[Ss]urface tension\b"));

    private TemporaryPackage package = null!;

    [SetUp]
    public void MakePackage() => package = new TemporaryPackage();

    [TearDown]
    public void RemovePackage() => package.Dispose();

    [TestCase("Emitters need the method *Standard* or *Robust*.")]
    [TestCase("With Standard and Robust emitters pour; with Thesis they do nothing.")]
    [TestCase("The method Thesis has no emitters.")]
    [TestCase("Without an emitter nothing of it is recorded, the paper *Standard* says.")]
    [TestCase("An emitter's material has Unity's Standard shader.")]
    public void ASentenceThatIsSoPasses(string sentence) =>
        Assert.That(MethodClaimCheck.Problem(sentence, emitters, ["Standard", "Robust"], out _), Is.Null);

    [TestCase("Emitters need the method *Standard*.", "Robust has 'Emitters' too")]
    [TestCase("With Standard, emitters pour; with another they do nothing.", "Robust has 'emitters' too")]
    [TestCase("Emitters work with Standard, Robust and Thesis.", "Thesis has no 'Emitters'")]
    [TestCase("The thesis's method has an emitter.", "Thesis has no 'emitter'")]
    [TestCase("There are no emitters.", "is denied")]
    public void ASentenceThatIsNotSoIsFound(string sentence, string finding) =>
        Assert.That(MethodClaimCheck.Problem(sentence, emitters, ["Standard", "Robust"], out _), Does.Contain(finding));

    [Test]
    public void WhatOneMethodAloneHasIsDeniedOfTheOthersOnly()
    {
        Assert.That(MethodClaimCheck.Problem("Robust has no surface tension.", tension, ["Standard"], out _), Is.Null);
        Assert.That(MethodClaimCheck.Problem("Standard has no surface tension.", tension, ["Standard"], out _), Is.Not.Null);
        Assert.That(MethodClaimCheck.Problem("No surface tension.", tension, ["Standard"], out _), Is.Not.Null);
    }

    [TestCase("Stereo rendering is not supported for water.", true)]
    [TestCase("There is no stereo.", true)]
    [TestCase("Standard draws no differently in stereo.", false)]
    [TestCase("Multiview is not supported in stereo.", false)]
    public void WhatThePackageHasIsNotDenied(string sentence, bool isFound) => Assert.That(
        MethodClaimCheck.Problem(sentence, new Capability("", "stereo", new Regex(@"\b[Ss]tereo(?: rendering)?\b")), ["Standard", "Robust", "Thesis"], out _), isFound ? Is.Not.Null : Is.Null);

    [Test]
    public void PagesCommentsAndMessagesAreRead()
    {
        package.Write(Data + "capabilities.csv", "feature,label,words\nChangingCount,emitters,[Ee]mitters?\n")
            .Write("Documentation~/page.md", "Pour.\n\nEmitters need Standard.\n").Write("Documentation~/CHANGELOG.md", "Emitters, with Standard.\n")
            .Write("Runtime/E.cs", "/// <summary>An emitter. Method\n/// <see cref=\"Standard\"/> Standard, for an emitter.</summary>\nclass E { string m = \"the emitter needs \" +\n    \"the method Standard\"; }\n");
        Assert.That(new MethodClaimCheck(package.Packages, _ => ["Standard", "Robust"]).Run().Findings.Select(f => f.Split(':')[0].Replace('\\', '/')),
            Is.EquivalentTo(new[] { "Packages/com.sphfluid/Documentation~/page.md(3)", "Packages/com.sphfluid/Runtime/E.cs(1)", "Packages/com.sphfluid/Runtime/E.cs(3)" }));
    }

    [TestCase("tank Tank 64x36 1x1 0.5 1", "![after 0.5 and 1 s](images/tank.png)", "picture", 0)]
    [TestCase("tank Tank 64x36 1x1 0.5 2", "![x](images/tank.png)", "picture", 1)]
    [TestCase("tank Pool 64x36 1x1 0.5 1", "![x](images/tank.png)", "picture", 1)]
    [TestCase("tank Tank 96x54 1x1 0.5 1", "![x](images/tank.png)", "picture", 1)]
    [TestCase("tank Tank 64x36 1x1 0.5 1\npool Pool 64x36 1x1 1", "![x](images/tank.png)", "picture", 1)]
    [TestCase("tank Tank 64x36 1x1 0.5 1", "![after 0.5 and 2 s](images/tank.png)", "picture", 1)]
    [TestCase("tank Tank 64x36 1x1 0.5 1", "![x](images/tank.png)\n\nFrames of `./run play --scene Tank --size 64x36`.", "picture", 1)]
    [TestCase("tank Tank 64x36 1x1 0.5 1", "![x](images/tank.png)", "another picture", 1)]
    public void APictureIsWhatItsScriptMadeAndItsPageSays(string script, string page, string picture, int findings)
    {
        string hash = Convert.ToHexString(SHA256.HashData("picture"u8))[..12];
        package.Write("../../Headless/Docs/pictures.sh", $"done << 'PICTURES'\n{script}\nPICTURES\n".ReplaceLineEndings("\n")).Write("Documentation~/images/tank.png", picture).Write("Documentation~/page.md", page)
            .Write("Documentation~/images/pictures.csv", $"file,sample,command,moments,particles,device,date,data,sha256\ntank.png,Tank,./run play --scene Tank --size 64x36,0.5 1,9,Card,2026-01-02,,{hash}\n");
        Assert.That(new PictureCheck(package.Packages).Run().Findings, Has.Count.EqualTo(findings));
        Assert.That(new PictureFacts(package.Packages).Find(["tank"]), Is.EqualTo("`./run play --scene Tank --size 64x36` on Card, 2026-01-02"));
    }

    [Test]
    public void APictureThatIsNotRecordedIsFound()
    {
        package.Write("Documentation~/images/pictures.csv", "file,sample,command,moments,particles,device,date,data,sha256\n").Write("Documentation~/images/tank.png", "");
        Assert.That(new PictureCheck(package.Packages).Run().Findings, Has.One.Contains("does not record tank.png"));
    }

    [TestCase("It floats.", "FloatTests", 0)]
    [TestCase("It floats.", "FloatTests.ItFloats", 0)]
    [TestCase("It floats.", "FloatTests.ItFloats; benchmarks/a.csv", 0)]
    [TestCase("It floats.", "FloatTests.ItSinks", 1)]
    [TestCase("It floats.", "SinkTests", 1)]
    [TestCase("It floats.", "benchmarks/b.csv", 1)]
    [TestCase("It floats.", "", 1)]
    [TestCase("It sinks.", "FloatTests", 2)]
    public void AClaimHasWhatShowsIt(string claim, string evidence, int findings)
    {
        package.Write("../../README.md", "Text with 3 numbers.\n\n- It **floats**.\n").Write("../../Headless/Tests/FloatTests.cs", "void ItFloats() {}").Write("../../benchmarks/a.csv", "")
            .Write(Data + "claims.csv", $"claim,shown by\n\"{claim}\",\"{evidence}\"\n");
        Assert.That(new ClaimCheck(package.Packages).Run(update: false).Findings, Has.Count.EqualTo(findings));
    }

    [TestCase("https://a.example/b", "2026-01-02", true)]
    [TestCase("a page", "2026-01-02", false)]
    [TestCase("https://a.example/b", "last week", false)]
    public void AStatementAboutAnotherProgramHasASourceAndADay(string source, string day, bool isTaken)
    {
        package.Write(Data + "peers.csv", $"peer,about,says,source,read\nOther,Method,\"grid, in 2D\",{source},{day}\nOther,Colour,blue,https://a.example/c,2026-01-03\n");
        if (isTaken)
            Assert.That(PeerTable.Read(package.Project).Markdown, Is.EqualTo(
                "| | Method | Colour | Read |\n|---|---|---|---|\n| [Other](https://a.example/b) | grid, in 2D | [blue](https://a.example/c) | 2026-01-02 and 03 |\n"));
        else Assert.Throws<UnknownFactException>(() => PeerTable.Read(package.Project));
    }
}
