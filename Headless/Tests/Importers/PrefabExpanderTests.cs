using Headless.Importers;
using Headless.Importers.Scenes;
using Headless.Importers.Yaml;
using NUnit.Framework;

namespace Headless.Tests.Importers;

public sealed class PrefabExpanderTests
{
    private const string Start = "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n";
    private const string Inner = Start
        + "--- !u!1 &10\nGameObject:\n  m_Component:\n  - component: {fileID: 11}\n  m_Name: Inner\n"
        + "--- !u!4 &11\nTransform:\n  m_GameObject: {fileID: 10}\n  m_LocalPosition: {x: 1, y: 2, z: 3}\n  m_Father: {fileID: 0}\n"
        + "--- !u!114 &12\nMonoBehaviour:\n  m_GameObject: {fileID: 10}\n  target: {fileID: 11}\n";
    private static readonly string Middle = Start
        + "--- !u!1 &20\nGameObject:\n  m_Name: Middle\n"
        + "--- !u!4 &21\nTransform:\n  m_GameObject: {fileID: 20}\n  m_Father: {fileID: 0}\n"
        + Instance(300, "inner", "{fileID: 21}", Change(10, "inner", "m_Name", "Renamed"));

    private readonly List<string> reports = [];

    private static string Change(long target, string guid, string path, string value, string reference = "{fileID: 0}") =>
        $"    - target: {{fileID: {target}, guid: {guid}, type: 3}}\n      propertyPath: {path}\n      value: {value}\n      objectReference: {reference}\n";

    private static string Instance(long id, string guid, string parent, string changes, string removed = "[]") =>
        $"--- !u!1001 &{id}\nPrefabInstance:\n  m_Modification:\n    m_TransformParent: {parent}\n    m_Modifications:\n{changes}    m_RemovedComponents: {removed}\n  m_SourcePrefab: {{fileID: 100100000, guid: {guid}, type: 3}}\n";

    private SourceFile Expand(string text)
    {
        var expander = new PrefabExpander((guid, where) => guid switch
        {
            "inner" => ("inner.prefab", UnityYaml.ParseDocuments(Inner, "inner.prefab")),
            "middle" => ("middle.prefab", UnityYaml.ParseDocuments(Middle, "middle.prefab")),
            "loop" => ("loop.prefab", UnityYaml.ParseDocuments(Start + Instance(1, "loop", "{fileID: 0}", ""), "loop.prefab")),
            _ => throw new ImportException($"{where}: no prefab {guid}"),
        }, reports.Add);
        return expander.Expand("t.unity", UnityYaml.ParseDocuments(Start + text, "t.unity"));
    }

    [Test]
    public void OverridesChangeThisInstanceOnly()
    {
        SourceFile file = Expand(Instance(1, "inner", "{fileID: 0}", Change(11, "inner", "m_LocalPosition.y", "9")) + Instance(2, "inner", "{fileID: 0}", Change(10, "inner", "m_Name", "Second")));
        SourceObject[] transforms = [.. file.Objects.Where(o => o.ClassId == ClassIds.Transform)];
        Assert.That(transforms.Select(t => t.Body.Map("m_LocalPosition")!.Float("y")), Is.EqualTo(new[] { 9f, 2f }));
        Assert.That(file.Objects.Where(o => o.ClassId == ClassIds.GameObject).Select(o => o.Name), Is.EqualTo(new[] { "Inner", "Second" }));
    }

    [Test]
    public void ReferencesInAnInstanceStayInIt()
    {
        SourceFile file = Expand(Instance(1, "inner", "{fileID: 0}", "") + Instance(2, "inner", "{fileID: 0}", ""));
        foreach (SourceObject script in file.Objects.Where(o => o.ClassId == ClassIds.MonoBehaviour))
        {
            FileReference reference = FileReference.Read(script.Body["target"], script.Scope);
            Assert.That(reference.Scope.Find(reference.FileId)!.Scope, Is.SameAs(script.Scope));
        }
    }

    [Test]
    public void AReferenceOverrideMeansTheOuterFile()
    {
        SourceFile file = Expand("--- !u!4 &5\nTransform:\n  m_Father: {fileID: 0}\n" + Instance(1, "inner", "{fileID: 5}", Change(12, "inner", "target", "", "{fileID: 5}")));
        SourceObject script = file.Objects.Single(o => o.ClassId == ClassIds.MonoBehaviour);
        FileReference reference = FileReference.Read(script.Body["target"], script.Scope);
        Assert.That(reference.Scope.Find(reference.FileId), Is.SameAs(file.Scope.Find(5)));
        SourceObject root = file.Objects.Last(o => o.ClassId == ClassIds.Transform);
        FileReference father = FileReference.Read(root.Body["m_Father"], root.Scope);
        Assert.That(father.Scope.Find(father.FileId), Is.SameAs(file.Scope.Find(5)));
    }

    [Test]
    public void AReferenceCanBeOverriddenToNull()
    {
        SourceFile file = Expand(Instance(1, "inner", "{fileID: 0}", Change(12, "inner", "target", "")));
        SourceObject script = file.Objects.Single(o => o.ClassId == ClassIds.MonoBehaviour);
        Assert.That(FileReference.Is(script.Body["target"]) && FileReference.Read(script.Body["target"], script.Scope).IsNull);
    }

    [Test]
    public void StrippedObjectsStandForThoseOfTheInstance()
    {
        SourceFile file = Expand(Instance(1, "inner", "{fileID: 0}", "")
            + "--- !u!4 &77 stripped\nTransform:\n  m_CorrespondingSourceObject: {fileID: 11, guid: inner, type: 3}\n  m_PrefabInstance: {fileID: 1}\n");
        Assert.That(file.Scope.Find(77), Is.SameAs(file.Objects.Single(o => o.ClassId == ClassIds.Transform)));
        Assert.That(file.Scope.Find(1), Is.SameAs(file.Scope.Find(77)), "the instance's own id stands for its root");
    }

    [Test]
    public void NestedPrefabsAreReachedThroughTheXorOfTheirIds()
    {
        SourceFile file = Expand(Instance(1, "middle", "{fileID: 0}", Change(300 ^ 11, "middle", "m_LocalPosition.x", "5")));
        SourceObject nested = file.Objects.Single(o => o.Name == "Renamed");
        SourceObject transform = file.Objects.Single(o => o.ClassId == ClassIds.Transform && o.Scope == nested.Scope);
        Assert.That(transform.Body.Map("m_LocalPosition")!.Float("x"), Is.EqualTo(5));
    }

    [Test]
    public void RemovedComponentsAreGone() =>
        Assert.That(Expand(Instance(1, "inner", "{fileID: 0}", "", "\n    - {fileID: 12, guid: inner, type: 3}")).Objects.Any(o => o.ClassId == ClassIds.MonoBehaviour), Is.False);

    [Test]
    public void APrefabInItselfIsAnError() =>
        Assert.That(() => Expand(Instance(1, "loop", "{fileID: 0}", "")), Throws.TypeOf<ImportException>().With.Message.Contains("contains itself"));

    [Test]
    public void AMissingPrefabNamesTheInstance() =>
        Assert.That(() => Expand(Instance(9, "gone", "{fileID: 0}", "")), Throws.TypeOf<ImportException>().With.Message.EqualTo("t.unity: PrefabInstance 9: no prefab gone"));
}
