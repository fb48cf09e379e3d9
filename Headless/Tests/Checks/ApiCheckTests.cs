using Headless.Checks;
using Headless.Checks.Api;
using NUnit.Framework;

namespace Headless.Tests.Checks;

public sealed class ApiCheckTests
{
    [Test]
    public void CodeOfBothLinesPasses()
    {
        var reports = Run("using UnityEngine; class A : MonoBehaviour { void Update() => transform.position += Vector3.up * Time.deltaTime; }");

        Assert.That(reports.SelectMany(r => r.Findings), Is.Empty);
        Assert.That(reports, Has.Count.EqualTo(6));
    }

    [TestCase("UnityEngine.Object.FindObjectsOfType<UnityEngine.Camera>()", "6000.0", "CS0618", TestName = "obsolete in the newer line")]
    [TestCase("new UnityEngine.Rigidbody().linearVelocity", "2022.3", "CS1061", TestName = "absent in the older line")]
    [TestCase("UnityEngine.Mathf.NoSuchThing()", "2022.3", "CS0117", TestName = "absent in both")]
    [TestCase("new UnityEngine.Camera().scene", "player", "only in the Editor", TestName = "an engine member of the Editor")]
    [TestCase("UnityEditor.EditorApplication.isPlaying", "player", "CS0234", TestName = "the Editor's API in a player")]
    public void MembersThatAUserDoesNotHaveAreFound(string expression, string where, string message)
    {
        var reports = Run($"class A {{ object B() => {expression}; }}");

        Assert.That(reports.Where(r => r.Name.Contains(where)).SelectMany(r => r.Findings), Has.Some.Contains(message));
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

    private static List<CheckReport> Run(string source)
    {
        using var package = new TemporaryPackage().Write("Runtime/A.cs", source);
        return new ApiCheck(package.Packages).Run().ToList();
    }
}
