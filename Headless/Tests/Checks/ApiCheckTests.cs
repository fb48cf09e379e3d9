using Headless.Checks;
using Headless.Checks.Api;
using NUnit.Framework;
using System.Reflection;

namespace Headless.Tests.Checks;

public sealed class ApiCheckTests
{
    // Those of all cases, a file each, are compiled together.
    private static readonly List<string> expressions =
        [.. typeof(ApiCheckTests).GetMethods().SelectMany(m => m.GetCustomAttributes<TestCaseAttribute>()).Select(c => (string)c.Arguments[0]!)];

    private static readonly Lazy<List<CheckReport>> ofExpressions = new(() =>
    {
        using var package = new TemporaryPackage()
            .Write("Runtime/A.asmdef", """{ "name": "A", "references": [ "Unity.Mathematics" ], "includePlatforms": [], "defineConstraints": [] }""");
        for (int i = 0; i < expressions.Count; i++) package.Write($"Runtime/C{i}.cs", $"class C{i} {{ object B() => {expressions[i]}; }}");
        return [.. new ApiCheck(package.Packages).Run()];
    });

    [Test]
    public void CodeOfAllLinesPasses()
    {
        var reports = Run("using UnityEngine; class A : MonoBehaviour { void Update() => transform.position += Vector3.up * Time.deltaTime; }");

        Assert.That(reports.SelectMany(r => r.Findings), Is.Empty);
        Assert.That(reports, Has.Count.EqualTo(3 * UnityLine.All.Count));
    }

    [TestCase("UnityEngine.Object.FindObjectsOfType<UnityEngine.Camera>()", "6000.0", "CS0618", TestName = "obsolete in the newer line")]
    [TestCase("new UnityEngine.Rigidbody().linearVelocity", "2022.3", "CS1061", TestName = "absent in the older line")]
    [TestCase("UnityEngine.Mathf.NoSuchThing()", "2022.3", "CS0117", TestName = "absent in both")]
    [TestCase("new UnityEngine.Camera().scene", "player", "only in the Editor", TestName = "an engine member of the Editor")]
    [TestCase("UnityEditor.EditorApplication.isPlaying", "player", "CS0234", TestName = "the Editor's API in a player")]
    [TestCase("new UnityEngine.Terrain()", "without modules", "needs a module", TestName = "a module that a project may not have")]
    public void MembersThatAUserDoesNotHaveAreFound(string expression, string where, string message)
    {
        Assert.That(FindingsOf(expression, where), Has.Some.Contains(message));
    }

    [TestCase("new UnityEngine.Camera().GetInstanceID()", "6000.5", "6000.3", "CS0619", TestName = "an error from 6000.5 on")]
    [TestCase("UnityEngine.Object.FindObjectsByType<UnityEngine.Camera>()", "6000.3", "6000.5", "CS1501", TestName = "there from 6000.4 on")]
    [TestCase("UnityEngine.Object.FindObjectsByType<UnityEngine.Camera>(UnityEngine.FindObjectsSortMode.None)", "6000.5", "6000.3", "CS0618", TestName = "obsolete from 6000.4 on")]
    [TestCase("(Unity.Mathematics.float3)new UnityEngine.Rigidbody().velocity", "6000.0", "2022.3", "CS0618", TestName = "obsolete behind a conversion")]
    public void EachLineIsCheckedByItsOwnApi(string expression, string fails, string passes, string message)
    {
        Assert.That(FindingsOf(expression, fails), Has.Some.Contains(message));
        Assert.That(FindingsOf(expression, passes), Is.Empty);
    }

    [Test]
    public void AnAlphaOnlyGetsANote()
    {
        var reports = Run("class A { object B() => new UnityEngine.Camera().GetInstanceID(); }").FindAll(r => r.Name.Contains("6000.7"));

        Assert.That(reports.SelectMany(r => r.Findings), Is.Empty);
        Assert.That(reports.SelectMany(r => r.Notes), Has.Some.Contains("CS0619"));
    }

    [Test]
    public void SamplesAreChecked()
    {
        using var package = new TemporaryPackage().Write("Runtime/A.cs", "class A { }")
            .Write("Samples~/S/S.asmdef", """{ "name": "S", "references": [], "includePlatforms": [], "defineConstraints": [] }""")
            .Write("Samples~/S/S.cs", "public class S { object B() => new UnityEngine.Camera().GetInstanceID(); }");

        Assert.That(new ApiCheck(package.Packages).Run().SelectMany(r => r.Findings).Distinct(), Is.EqualTo(new[] { "S: S.cs(1): CS0619 'Object.GetInstanceID()' is obsolete: 'obsolete'" }));
    }

    // Only files that can notice a difference are compiled again: these two do not name what differs.
    [Test]
    public void UsesOfWhatAnotherFileDeclaresAreFound()
    {
        using var package = new TemporaryPackage().Write("Runtime/A.cs", """
            static class A
            {
            #if UNITY_EDITOR
                public static void InTheEditor() { }
            #endif
            #if UNITY_6000_0_OR_NEWER
                public static float Mass() => 0;
            #else
                public static int Mass() => 0;
            #endif
            }
            """).Write("Runtime/B.cs", "class B { void Call() => A.InTheEditor(); }").Write("Runtime/C.cs", "class C { int Call() => A.Mass(); }");
        var reports = new ApiCheck(package.Packages).Run().ToList();

        Assert.That(Files("2022.3 Editor"), Is.Empty);
        Assert.That(Files("2022.3 player"), Is.EqualTo(new[] { "A: B.cs(1): CS0117" }));
        Assert.That(Files("6000.3 Editor"), Is.EqualTo(new[] { "A: C.cs(1): CS0266" }));
        Assert.That(Files("6000.3 player"), Is.EqualTo(new[] { "A: B.cs(1): CS0117", "A: C.cs(1): CS0266" }));

        IEnumerable<string> Files(string pass) => reports.Where(r => r.Name.Contains(pass + ",") && !r.Name.Contains("without")).SelectMany(r => r.Findings).Select(f => f[..f.IndexOf(' ', f.IndexOf("CS"))]);
    }

    [TestCase("URP_COMPATIBILITY_MODE", "A with URP_COMPATIBILITY_MODE")]
    [TestCase("!URP_COMPATIBILITY_MODE", "A")]
    public void AnOptionalAssemblyIsCompiledWithTheLeftoverAndWithout(string condition, string named)
    {
        var findings = RunOptional($"#if {condition}\nclass A {{ object B() => Missing; }}\n#endif");

        Assert.That(findings("2022.3 Editor").Concat(findings("6000.5 player")).ToList(), Has.Count.EqualTo(2).And.All.StartsWith(named + ": A.cs(2): CS0103"));
    }

    [TestCase("useNativeRenderPass", "6000.0", "")]
    [TestCase("useNativeRenderPass", "6000.3", "A with newer render pipelines: A.cs(1): CS0618")]
    [TestCase("useNativeRenderPass", "6000.5", "A: A.cs(1): CS0618")]
    [TestCase("tileOnlyMode", "2022.3", "A: A.cs(1): CS1061")]
    [TestCase("tileOnlyMode", "6000.3", "A: A.cs(1): CS1061")]
    [TestCase("tileOnlyMode", "6000.5", "")]
    public void RenderPipelinesOfALineWithoutAListLieBetweenTwo(string member, string line, string expected)
    {
        var findings = RunOptional($"class A {{ object B(UnityEngine.Rendering.Universal.UniversalRendererData d) => d.{member}; }}")(line + " Editor")
            .FindAll(f => !f.Contains("URP_COMPATIBILITY_MODE"));

        Assert.That(findings, expected.Length == 0 ? Is.Empty : Has.Count.EqualTo(1).And.All.StartsWith(expected));
    }

    [Test]
    public void TestsKeepToUnitysNUnit()
    {
        using var package = new TemporaryPackage()
            .Write("Tests/T.asmdef", """{ "name": "T", "references": [], "includePlatforms": [], "defineConstraints": ["UNITY_INCLUDE_TESTS"] }""")
            .Write("Tests/T.cs", "class T { void M() => NUnit.Framework.Assert.Multiple(() => { }); }");

        Assert.That(new ApiCheck(package.Packages).Run().SelectMany(r => r.Findings), Has.Some.Contains("newer than Unity's NUnit 3.5"));
    }

    [Test]
    public void CSharp10IsRefused()
    {
        Assert.That(Run("namespace N; class A { }").SelectMany(r => r.Findings), Has.Some.Contains("CS8773"));
    }

    [Test]
    public void MissingDocumentationIsFound()
    {
        Assert.That(Run("public class A { }").SelectMany(r => r.Findings), Has.Some.Contains("CS1591"));
    }

    [Test]
    public void NewerCodeBehindItsDefineIsCheckedInItsLineOnly()
    {
        var reports = Run("""
            class A
            {
            #if UNITY_6000_0_OR_NEWER
                object B() => new UnityEngine.Rigidbody().linearVelocity;
            #else
                object B() => new UnityEngine.Rigidbody().velocity;
            #endif
            }
            """);

        Assert.That(reports.SelectMany(r => r.Findings), Is.Empty);
    }

    private static IEnumerable<string> FindingsOf(string expression, string pass) => ofExpressions.Value.Where(r => r.Name.Contains(pass))
        .SelectMany(r => r.Findings).Where(f => f.Contains($" C{expressions.IndexOf(expression)}.cs("));

    private static Func<string, List<string>> RunOptional(string source)
    {
        using var package = new TemporaryPackage().Write("Runtime/A.cs", source).Write("Runtime/A.asmdef", """
            {
                "name": "A", "references": ["Unity.RenderPipelines.Core.Runtime", "Unity.RenderPipelines.Universal.Runtime"], "includePlatforms": [],
                "defineConstraints": ["OPTIONAL"], "versionDefines": [{ "name": "com.unity.render-pipelines.universal", "expression": "14.0.0", "define": "OPTIONAL" }]
            }
            """);
        List<CheckReport> reports = [.. new ApiCheck(package.Packages).Run()];
        return pass => [.. reports.Where(r => r.Name.Contains(pass + ",") && !r.Name.Contains("without")).SelectMany(r => r.Findings)];
    }

    private static List<CheckReport> Run(string source)
    {
        using var package = new TemporaryPackage().Write("Runtime/A.cs", source);
        return new ApiCheck(package.Packages).Run().ToList();
    }
}
