using Headless.Importers;
using Headless.Importers.Yaml;
using NUnit.Framework;

namespace Headless.Tests.Importers;

public sealed class UnityYamlTests
{
    private const string Start = "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n";

    private static YamlMap Body(string fields) => UnityYaml.ParseDocuments(Start + "--- !u!114 &1\nMonoBehaviour:\n" + fields, "t.asset")[0].Body;

    [Test]
    public void ReadsSeveralDocumentsWithNegativeIdsAndStrippedOnes()
    {
        List<UnityDocument> documents = UnityYaml.ParseDocuments(
            Start + "--- !u!1 &-8679921383154817045\nGameObject:\n  m_Name: A\n--- !u!4 &42 stripped\nTransform:\n  m_PrefabInstance: {fileID: 7}\n", "t.unity");
        Assert.That(documents, Has.Count.EqualTo(2));
        Assert.That((documents[0].ClassId, documents[0].FileId, documents[0].ClassName, documents[0].Stripped), Is.EqualTo((1, -8679921383154817045, "GameObject", false)));
        Assert.That((documents[1].ClassId, documents[1].FileId, documents[1].Stripped), Is.EqualTo((4, 42L, true)));
        Assert.That(documents[1].Body.Map("m_PrefabInstance")!.Long("fileID"), Is.EqualTo(7));
    }

    [Test]
    public void ReadsTheScalarsOfTheEditor()
    {
        YamlMap map = Body("""
              empty: 
              near clip plane: 0.3
              <Viscosity>k__BackingField: 1e-06
              big: 3.4028235e+38
              infinite: Infinity
              minusZero: -0
              mask: 4294967295
              quoted: 'a ''b'': c'
              escaped: "\u27F5BACK\n"
              hash: a#b

            """);
        Assert.That(map.Text("empty", "x"), Is.EqualTo(""));
        Assert.That(map.Float("near clip plane"), Is.EqualTo(0.3f));
        Assert.That(map.Float("<Viscosity>k__BackingField"), Is.EqualTo(1e-6f));
        Assert.That(map.Float("big"), Is.EqualTo(float.MaxValue));
        Assert.That(map.Float("infinite"), Is.EqualTo(float.PositiveInfinity));
        Assert.That(float.IsNegative(map.Float("minusZero")), Is.True);
        Assert.That(map.Long("mask"), Is.EqualTo(4294967295));
        Assert.That(map.Text("quoted"), Is.EqualTo("a 'b': c"));
        Assert.That(map.Text("escaped"), Is.EqualTo("\u27F5BACK\n"));
        Assert.That(map.Text("hash"), Is.EqualTo("a#b"));
    }

    [Test]
    public void ReadsFlowMapsAndListsAtTheKeysIndent()
    {
        YamlMap map = Body("  position: {x: 1, y: -2.5, z: 0}\n  items:\n  - {fileID: 3}\n  - name: a\n    size: 2\n  none: []\n");
        Assert.That(map.Map("position")!.Float("y"), Is.EqualTo(-2.5f));
        Assert.That(map.List("items"), Has.Count.EqualTo(2));
        Assert.That(((YamlMap)map.List("items")[1]).Int("size"), Is.EqualTo(2));
        Assert.That(map.List("none"), Is.Empty);
    }

    [Test]
    public void ReadsWrappedFlowMapsAndFoldedText()
    {
        YamlMap map = Body("  reference: {fileID: 11400000, guid: 0123456789abcdef0123456789abcdef,\n    type: 2}\n  note: a long text that\n    goes on\n");
        Assert.That(map.Map("reference")!.Int("type"), Is.EqualTo(2));
        Assert.That(map.Text("note"), Is.EqualTo("a long text that goes on"));
    }

    [Test]
    public void LineEndingsOfWindowsAreRead()
    {
        UnityDocument document = UnityYaml.ParseDocuments((Start + "--- !u!1 &5\nGameObject:\n  m_Name: A\n").Replace("\n", "\r\n"), "t.unity")[0];
        Assert.That(document.Body.Text("m_Name"), Is.EqualTo("A"));
    }

    [Test]
    public void AnIdUsedTwiceIsAnErrorWithItsLine()
    {
        var error = Assert.Throws<ImportException>(() => UnityYaml.ParseDocuments(Start + "--- !u!1 &5\nGameObject:\n  a: 1\n--- !u!4 &5\nTransform:\n  a: 1\n", "t.unity"));
        Assert.That(error!.Message, Does.StartWith("t.unity:6: fileID 5 is used twice"));
    }

    [Test]
    public void BrokenYamlIsAnErrorWithItsLine()
    {
        var error = Assert.Throws<ImportException>(() => UnityYaml.ParseDocuments(Start + "--- !u!1 &5\nGameObject:\n  a: 1\n  b: 'x' y\n", "t.unity"));
        Assert.That(error!.Message, Does.Match("^t\\.unity:[67]: not readable as YAML"));
        error = Assert.Throws<ImportException>(() => UnityYaml.ParseDocuments(Start + "--- !u!1 &5\nGameObject:\n  b: {x: 1\n  c: 2\n", "t.unity"));
        Assert.That(error!.Message, Does.Match("^t\\.unity:[4-7]: not readable as YAML"));
    }

    [Test]
    public void ABinaryAssetIsAnErrorWithTheCure()
    {
        string file = Path.GetTempFileName();
        File.WriteAllBytes(file, [0, 0, 1, 2]);
        Assert.That(() => UnityYaml.ReadDocuments(file), Throws.TypeOf<ImportException>().With.Message.Contains("Force Text"));
        File.Delete(file);
    }
}
