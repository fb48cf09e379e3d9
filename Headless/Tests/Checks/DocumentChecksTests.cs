using Headless.Checks.Documents;
using NUnit.Framework;

namespace Headless.Tests.Checks;

/// <summary>Every kind of fault that a document can have is found, and what is right passes.</summary>
public sealed class DocumentChecksTests
{
    private const string Help = """
        #!/bin/bash
        [[ $1 == paint ]] && { printf './run paint [flags]\n  --brush NAME   the brush\n'; exit 0; }
        cat << 'END'
        ./run                   plays the scene
        ./run play [flags]      plays a scene
        ./run paint [flags]     paints; its own help lists the flags
        ./run --help            this text

        play
          --seconds S           simulated seconds    3
          --no-images           no pictures

        Errors: exit code 1, see --nothing.
        END
        """;

    private TemporaryPackage package = null!;

    [SetUp]
    public void MakePackage() => package = new TemporaryPackage();

    [TearDown]
    public void RemovePackage() => package.Dispose();

    [Test]
    public void CommandsOfTheHelpPass() => Assert.That(Commands(
        "`./run`, `./run --seconds 1`, `./run play --no-images --seconds=2`, `./run paint --brush oil`, `./run\nplay --seconds\n3`\n\n```\n./run play \\\n    --seconds 3\n./run paint\n```\n"
        + "`./run VERB --help`"), Is.Empty);

    [TestCase("`./run dance`", "./run has no verb 'dance'")]
    [TestCase("`./run --minutes 3`", "./run play has no flag '--minutes'")]
    [TestCase("`./run play --seconds 3 --nothing`", "./run play has no flag '--nothing'")]
    [TestCase("`./run paint --seconds 3`", "./run paint has no flag '--seconds'")]
    [TestCase("```sh\n./run play --secods 3\n```", "./run play has no flag '--secods'")]
    [TestCase("`./Headless/Walk/gone.sh`", "there is no './Headless/Walk/gone.sh'")]
    public void ACommandThatTheHelpLacksIsFound(string text, string finding) => Assert.That(Commands(text), Has.One.Contains(finding));

    [Test]
    public void FilesThatAreThereOrAreWrittenPass()
    {
        package.Write("Runtime/Deep/Pass.compute", "").Write("Runtime/Writer.cs", "class Writer { string f = \"table.csv\"; }").Write("Tests/PassTests.cs", "");
        Assert.That(Files("`Runtime/Deep/Pass.compute`, `Pass.compute`, `Packages/com.sphfluid/Runtime`, `Runtime/`, `table.csv`, `PassTests`, `PassTests.ItPasses`, `Build/x/any.csv`, "
            + "`FILE.ply`, `DIR/table.csv`, `a / b`\n```\nnowhere/at-all.cs\n```"), Is.Empty);
    }

    [TestCase("`Runtime/Gone.cs`", "Runtime/Gone.cs")]
    [TestCase("`Gone.compute`", "Gone.compute")]
    [TestCase("`Runtime/Gone/`", "Runtime/Gone/")]
    [TestCase("`Gone/Deep`", "Gone/Deep")]
    [TestCase("`GoneTests`", "GoneTests")]
    [TestCase("`gone.csv`", "gone.csv")]
    public void AFileThatIsNotThereIsFound(string text, string name) => Assert.That(Files(text), Has.One.Contains($"there is no '{name}'"));

    [Test]
    public void FieldsAndComponentsOfTheInspectorPass()
    {
        WriteComponent();
        Assert.That(Fields("| Field | Meaning |\n|---|---|\n| Rest Density ρ0 | |\n| **Fast Color**, Label By Hand | |\n| `code` | |\n\n| Component | For |\n|:--|--|\n| Fluid Volume | |\n"), Is.Empty);
    }

    [TestCase("| Field | Meaning |\n|---|---|\n| Rest Dense | |", "no inspector has a field 'Rest Dense'")]
    [TestCase("| Field | Meaning |\n|---|---|\n| Rest Density, Colour | |", "no inspector has a field 'Colour'")]
    [TestCase("| Component | For |\n|---|---|\n| Fluid Volumes | |", "there is no component or asset 'Fluid Volumes'")]
    public void AFieldOrComponentThatIsNotThereIsFound(string text, string finding)
    {
        WriteComponent();
        Assert.That(Fields(text), Has.One.Contains(finding));
    }

    [Test]
    public void FilesMembersAndStatementsCompile() => Assert.That(Code("""
        ```csharp
        using UnityEngine;
        public class Whole : MonoBehaviour { void Start() => name = "x"; }
        ```
        ```csharp
        int count;
        void Update() => count++;
        ```
        <!-- given: Transform place; -->
        ```csharp
        Vector3 up = place.up;
        foreach (Transform child in place) child.position = up;
        ```
        ```csharp
        while (isActiveAndEnabled) yield return null;
        ```
        <!-- not compiled: another package's -->
        ```csharp
        Nothing.AtAll();
        ```
        ```hlsl
        float x = 1;
        ```
        """), Is.Empty);

    [TestCase("```csharp\ntransform.Wobble();\n```", "line 2: CS1061")]
    [TestCase("text\n\n```csharp\nvoid Update() { missing = 1; }\n```", "line 4: CS0103")]
    [TestCase("```csharp\nusing UnityEngine;\nclass A : MonoBehaviour { Missing m; }\n```", "line 3: CS0246")]
    [TestCase("```csharp\nint x = ;\n```", "CS1525")]
    [TestCase("```csharp\nvar all = Object.FindObjectsOfType<Camera>();\n```", "CS0618")]
    public void CodeThatDoesNotCompileIsFoundWithItsLine(string text, string finding) => Assert.That(Code(text), Has.Some.Contains(finding));

    [TestCase("Unity 2022.3 to\n6000.7 and a GPU", 0)]
    [TestCase("the lists of 2022.3, 6000.0, 6000.3, 6000.5 and the alpha 6000.7; in 6000.4 lights differ", 0)]
    [TestCase("Unity 2022.3 LTS, or 6000.0 and newer", 2)]
    [TestCase("2022.3 and 6000.0", 1)]
    public void TheSupportedUnityIsSaidTheOneWay(string text, int findings)
    {
        Write(text);
        Assert.That(new SupportedUnityCheck(package.Packages).Run().Findings, Has.Count.EqualTo(findings));
    }

    [Test]
    public void ManualsSayTheSupportedUnity()
    {
        package.Write("Documentation~/platforms.md", "Any Unity.\n");
        Assert.That(new SupportedUnityCheck(package.Packages).Run().Findings, Has.One.Contains("platforms.md does not say"));
    }

    [Test]
    public void APictureInHtmlLeadsSomewhere()
    {
        Write("<img src=\"images/gone.webp\" alt=\"x\">");
        Assert.That(new LinkCheck(package.Packages).Run().Findings, Has.One.Contains("the link to 'images/gone.webp' leads nowhere"));
    }

    [Test]
    public void ATableThatNoDocumentNamesIsFound()
    {
        package.Write("../../benchmarks/README.md", "`leaks/box-2026-01-02`, `model/` with `waves.csv`, `solver-box.csv`\n")
            .Write("../../benchmarks/leaks/box-2026-01-02/leaks.csv", "a\n").Write("../../benchmarks/leaks/box-2026-01-01/leaks.csv", "a\n")
            .Write("../../benchmarks/model/waves.csv", "a\n").Write("../../benchmarks/model/steps.csv", "a\n")
            .Write("../../benchmarks/solver-box.csv", "a\n").Write("../../benchmarks/solver-tin.csv", "a\n")
            .Write("../../benchmarks/leaks/box-2026-01-01/curves/one.csv", "a\n").Write("../../benchmarks/leaks/box-2026-01-01/leaks.png", "a");

        Assert.That(new BenchmarkTableCheck(package.Packages).Run().Findings.Select(f => f.Split(':')[0]),
            Is.EquivalentTo(new[] { "benchmarks/leaks/box-2026-01-01/leaks.csv", "benchmarks/model/steps.csv", "benchmarks/solver-tin.csv" }));
    }

    [TestCase(BenchmarkTableCheck.Most - 20, 0)]
    [TestCase(BenchmarkTableCheck.Most, 1)]
    public void TablesAreSmallAltogether(long bytes, int findings)
    {
        package.Write("../../benchmarks/README.md", "`a.csv`").Write("../../benchmarks/a.csv", new string('1', (int)bytes));

        Assert.That(new BenchmarkTableCheck(package.Packages).Run().Findings, Has.Count.EqualTo(findings));
    }

    private void WriteComponent() => package.Write("Runtime/V.cs", """
        [AddComponentMenu("SPH Fluid/Fluid Volume")] class V : MonoBehaviour { [SerializeField] float restDensity; [SerializeField] Color m_FastColor; void Draw() => Label("Label By Hand"); }
        """);

    private void Write(string text) => package.Write("Documentation~/page.md", text + "\n");

    private List<string> Commands(string text)
    {
        Write(text);
        File.WriteAllText(Path.Combine(package.Project, "run"), Help.ReplaceLineEndings("\n"));
        return new CommandCheck(package.Packages).Run().Findings;
    }

    private List<string> Files(string text)
    {
        Write(text);
        return new FileNameCheck(package.Packages).Run().Findings;
    }

    private List<string> Fields(string text)
    {
        Write(text);
        return new FieldNameCheck(package.Packages).Run().Findings;
    }

    private List<string> Code(string text)
    {
        // The scene that every snippet has is of the product's types.
        package.Write("Runtime/Types.cs", """
            namespace SphFluid
            {
                public class FluidSimulation { } public class FluidEmitter { } public class FluidDrain { } public class FluidForceZone { } public class FluidSensor { }
            }
            """);
        Write(text);
        return new SnippetCheck(package.Packages).Run().Findings;
    }
}
