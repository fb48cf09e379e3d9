using System.Reflection;
using Headless.Engine;
using Headless.Importers;
using Headless.Shaders;
using Headless.Tests.Importers;
using NUnit.Framework;

namespace Headless.Tests.Fuzz;

/// <summary>Files that once ended the player, or kept it busy: each is one line with file, line and cure.</summary>
[NonParallelizable]
public sealed class HostileFileTests
{
    private const string Start = "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n";
    private const string GuidA = "0000000000000000000000000000000a";
    private TemporaryProject project = null!;

    [SetUp]
    public void SetUp()
    {
        EngineState.Reset();
        project = new TemporaryProject();
    }

    [TearDown]
    public void TearDown()
    {
        PlaySession.End();
        EngineState.Reset();
        project.Dispose();
    }

    private static string Object(string layer = "0", string position = "{x: 0, y: 0, z: 0}", string father = "{fileID: 0}", string more = "") =>
        $"--- !u!1 &1\nGameObject:\n  m_Layer: {layer}\n  m_Name: A\n--- !u!4 &11\nTransform:\n  m_GameObject: {{fileID: 1}}\n"
        + $"  m_LocalPosition: {position}\n  m_Father: {father}\n{more}";

    private static string Child(long id, string father) =>
        $"--- !u!1 &{id}\nGameObject:\n  m_Name: N{id}\n--- !u!4 &{id + 1}\nTransform:\n  m_GameObject: {{fileID: {id}}}\n  m_Father: {father}\n";

    private static IEnumerable<TestCaseData> Scenes()
    {
        TestCaseData Case(string name, string scene, string message) => new TestCaseData(Start + scene, message).SetName($"AScene({name})");
        yield return Case("two parents of each other", Object(father: "{fileID: 21}") + Child(20, "{fileID: 11}"), @"Main\.unity:\d+: .* is its own ancestor: m_Father leads in a circle\. Set the m_Father");
        yield return Case("its own parent", Object(father: "{fileID: 11}"), "is its own ancestor");
        yield return Case("2,000 generations", Object() + string.Concat(Enumerable.Range(0, 2000).Select(i => Child(100 + 2 * i, i == 0 ? "{fileID: 11}" : $"{{fileID: {99 + 2 * i}}}"))), "more than 1000 ancestors");
        yield return Case("20,000 deep in flow", Object(more: "  m_X: " + new string('[', 20_000) + "\n"), "nested more than 64 deep");
        yield return Case("20,000 deep in blocks", Object(more: "  m_X:\n  " + string.Concat(Enumerable.Repeat("- ", 20_000)) + "\n"), "nested more than 64 deep");
        yield return Case("a word as number", Object(position: "{x: abc, y: 0, z: 0}"), @"Main\.unity:10: 'x' must be a number, found 'abc'\. Correct it, or restore");
        yield return Case("hexadecimal", Object(layer: "0x10"), @"Main\.unity:5: 'm_Layer' must be a whole number .*, found '0x10'");
        yield return Case("digits with underscores", Object(layer: "1_000"), "'m_Layer' must be a whole number .*, found '1_000'");
        yield return Case("a word as fileID", Object(father: "{fileID: abc}"), "'fileID' must be a whole number .*, found 'abc'");
        yield return Case("23 digits", Object(father: "{fileID: 12345678901234567890123}"), "found '12345678901234567890123'");
        yield return Case("an infinite place", Object(position: "{x: Infinity, y: 0, z: 0}"), "'m_LocalPosition' must be finite");
        yield return Case("a number beyond all floats", Object(position: "{x: 1e400, y: 0, z: 0}"), "found '1e400'");
        yield return Case("a layer that is none", Object(layer: "77"), "layer 77 is not from 0 to 31");
        yield return Case("a list as reference", Object(father: "[1, 2]"), "a reference {fileID: ...} was expected, found a list");
        yield return Case("two transforms", Object(more: "--- !u!4 &12\nTransform:\n  m_GameObject: {fileID: 1}\n"), "more than one Transform");
        yield return Case("cut off behind a header", Object() + "--- !u!1 &99", @"Main\.unity:12: the object has no body");
        yield return Case("a broken header", Object() + "--- u!1 &99\nGameObject:\n  m_Name: B\n", "that is no object header");
        yield return Case("no object", "", "the file holds no object");
        yield return Case("an alias of YAML", Object(more: "  m_A: &a [1]\n  m_B: *a\n"), "unexpected YAML");
        yield return Case("a huge array by override", Object() + Instance("regions.Array.size", "2000000000"), "come to more than 2000000 values");
    }

    private static string Instance(string path, string value) =>
        $"--- !u!1001 &80\nPrefabInstance:\n  m_Modification:\n    m_Modifications:\n    - target: {{fileID: 1, guid: {GuidA}, type: 3}}\n"
        + $"      propertyPath: {path}\n      value: {value}\n      objectReference: {{fileID: 0}}\n  m_SourcePrefab: {{fileID: 100100000, guid: {GuidA}, type: 3}}\n";

    [TestCaseSource(nameof(Scenes))]
    public void IsRefusedInOneLine(string scene, string message)
    {
        project.Add("Assets/A.prefab", Start + Object(), guid: GuidA);
        project.Add("Assets/Main.unity", scene);
        GuardedRun.Result result = GuardedRun.Of(() =>
        {
            UnityProject.Open(project.Root, _ => Assembly.GetExecutingAssembly(), new IncludeResolver(project.Root), _ => { });
            PlaySession.Begin("Assets/Main.unity");
        });
        Assert.That(result.Problem, Is.Null);
        Assert.That(result.Refusal, Does.Match(message));
    }

    private static IEnumerable<TestCaseData> Models()
    {
        const string Vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
        TestCaseData Case(string name, string obj, string message) => new TestCaseData(obj, message).SetName($"AModel({name})");
        yield return Case("a face of 100,000 corners", Vertices + "f " + string.Join(' ', Enumerable.Repeat("1 2 3", 33_334)) + "\n", @"M\.obj:4: a face with 100002 corners; at most 4096");
        yield return Case("100,000 continued lines", Vertices + "f 1 \\\n" + string.Concat(Enumerable.Repeat("2 \\\n", 100_000)) + "3\n", @"M\.obj:4: a statement goes on over more than 10000 lines");
        yield return Case("a line of 4 MB", Vertices + "f " + new string('1', 4 << 20) + "\n", @"M\.obj:4: a statement has more than 1048576 characters");
        yield return Case("a word as index", Vertices + "f 1 2 x\n", @"M\.obj:4: 'x' is not a vertex index\. Correct it");
        yield return Case("a word as number", "v 0 abc 0\n", @"M\.obj:1: 'v' needs a finite number as its component 2, found 'abc'");
        yield return Case("2,000,000 triangles", Vertices + string.Concat(Enumerable.Repeat("f 1 2 3\n", 2_000_000)), "more than 1000000 triangles");
        yield return Case("all corners at one point", string.Concat(Enumerable.Range(0, 60_000).Select(i => $"v {i} 0 0\n")) + string.Concat(Enumerable.Range(2, 50_000).Select(i => $"f 1 {i} {i + 1}\n")), "lie at \\(");
    }

    [TestCaseSource(nameof(Models))]
    public void IsRefusedInOneLineToo(string obj, string message)
    {
        project.Add("Assets/M.obj", obj, "ModelImporter:\n  tangentSpace:\n    normalImportMode: 1\n");
        GuardedRun.Result result = GuardedRun.Of(() =>
            UnityProject.Open(project.Root, _ => null, new IncludeResolver(project.Root), _ => { }).Assets.LoadMain("Assets/M.obj"));
        Assert.That(result.Problem, Is.Null);
        Assert.That(result.Refusal, Does.Match(message));
    }

    [Test]
    public void IncludesThatDoubleThemselvesAreBounded()
    {
        for (int i = 0; i < 40; i++) project.Add($"Assets/I{i}.hlsl", $"#include \"I{i + 1}.hlsl\"\n#include \"I{i + 1}.hlsl\"\n");
        project.Add("Assets/C.compute", "#pragma kernel K\n#include \"I0.hlsl\"\n[numthreads(1,1,1)] void K() {}\n");
        GuardedRun.Result result = GuardedRun.Of(() =>
            UnityProject.Open(project.Root, _ => null, new IncludeResolver(project.Root), _ => { }).Assets.LoadMain("Assets/C.compute"));
        Assert.That(result.Problem, Is.Null);
        Assert.That(result.Refusal, Does.Contain("more than 10000 files"));
    }
}
