using NUnit.Framework;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace Headless.Tests.Importers;

public sealed class SceneLoaderTests : SceneFixture
{
    private string script = "", sample = "";

    [SetUp]
    public void SetUp()
    {
        SceneProbe.Log.Clear();
        script = Project.Add("Assets/SceneProbe.cs", "");
        sample = Project.Add("Assets/SerializedSample.cs", "");
    }

    private static string Object(long id, string name, long transform, long father, string more = "", bool active = true, params long[] children) =>
        $"--- !u!1 &{id}\nGameObject:\n  m_Component:\n  - component: {{fileID: {transform}}}\n  m_Layer: 4\n  m_Name: {name}\n  m_TagString: Untagged\n  m_IsActive: {(active ? 1 : 0)}\n"
        + $"--- !u!4 &{transform}\nTransform:\n  m_GameObject: {{fileID: {id}}}\n  m_LocalRotation: {{x: 0, y: 0, z: 0, w: 1}}\n  m_LocalPosition: {{x: {id}, y: 0, z: 0}}\n  m_LocalScale: {{x: 2, y: 2, z: 2}}\n"
        + $"  m_Children: [{string.Join(", ", children.Select(c => $"{{fileID: {c}}}"))}]\n  m_Father: {{fileID: {father}}}\n" + more;

    private string Probe(long id, long owner, string fields = "", int enabled = 1) =>
        $"--- !u!114 &{id}\nMonoBehaviour:\n  m_GameObject: {{fileID: {owner}}}\n  m_Enabled: {enabled}\n  m_Script: {{fileID: 11500000, guid: {script}, type: 3}}\n{fields}";

    [Test]
    public void ReferencesAreSetBeforeTheFirstAwake()
    {
        PlayScene(Object(1, "First", 11, 0, Probe(21, 1, "  target: {fileID: 12}\n")) + Object(2, "Second", 12, 0, Probe(22, 2, "  target: {fileID: 11}\n")));
        Assert.That(SceneProbe.Log, Is.EqualTo(new[] { "First awake, target Second", "First enabled", "Second awake, target First", "Second enabled" }));
        Assert.That(Reports, Is.Empty);
    }

    [Test]
    public void HierarchyOrderAndLocalValuesAreThoseOfTheFile()
    {
        Scene scene = PlayScene(Object(1, "A", 11, 0, "", true, 13, 12) + Object(2, "B", 12, 11) + Object(3, "C", 13, 11) + Object(4, "D", 14, 0)
            + "--- !u!1660057539 &9223372036854775807\nSceneRoots:\n  m_Roots:\n  - {fileID: 14}\n  - {fileID: 11}\n");
        Assert.That(scene.name, Is.EqualTo("Main"));
        Assert.That(scene.GetRootGameObjects().Select(g => g.name), Is.EqualTo(new[] { "D", "A" }));
        Transform a = GameObject.Find("A").transform;
        Assert.That(Enumerable.Range(0, a.childCount).Select(i => a.GetChild(i).name), Is.EqualTo(new[] { "C", "B" }));
        Assert.That(a.GetChild(1).localPosition, Is.EqualTo(new Vector3(2, 0, 0)));
        Assert.That(a.GetChild(1).position, Is.EqualTo(new Vector3(5, 0, 0)));
        Assert.That(a.gameObject.layer, Is.EqualTo(4));
    }

    [Test]
    public void InactiveObjectsAndDisabledScriptsGetNoEnable()
    {
        PlayScene(Object(1, "Off", 11, 0, Probe(21, 1), active: false) + Object(2, "Disabled", 12, 0, Probe(22, 2, enabled: 0)));
        Assert.That(SceneProbe.Log, Is.EqualTo(new[] { "Disabled awake, target none" }));
    }

    [Test]
    public void PrefabInstancesAreLivingCopiesWithTheirOverrides()
    {
        string prefab = Project.Add("Assets/Thing.prefab", Start + Object(1, "Thing", 11, 0, Probe(21, 1, "  target: {fileID: 11}\n")));
        PlayScene(Object(5, "Scene", 15, 0, Probe(25, 5, $"  prefab: {{fileID: 1, guid: {prefab}, type: 3}}\n  target: {{fileID: 90}}\n"))
            + $"--- !u!1001 &80\nPrefabInstance:\n  m_Modification:\n    m_TransformParent: {{fileID: 15}}\n    m_Modifications:\n"
            + $"    - target: {{fileID: 1, guid: {prefab}, type: 3}}\n      propertyPath: m_Name\n      value: Copy\n      objectReference: {{fileID: 0}}\n"
            + $"    m_RemovedComponents: []\n  m_SourcePrefab: {{fileID: 100100000, guid: {prefab}, type: 3}}\n"
            + $"--- !u!4 &90 stripped\nTransform:\n  m_CorrespondingSourceObject: {{fileID: 11, guid: {prefab}, type: 3}}\n  m_PrefabInstance: {{fileID: 80}}\n");
        Assert.That(Reports, Is.Empty);
        Assert.That(SceneProbe.Log, Is.EqualTo(new[] { "Scene awake, target Copy", "Scene enabled", "Copy awake, target Copy", "Copy enabled" }));
        var scene = GameObject.Find("Scene").GetComponent<SceneProbe>();
        Assert.That(scene.transform.GetChild(0).name, Is.EqualTo("Copy"));
        Assert.That(scene.prefab!.name, Is.EqualTo("Thing"));
        Assert.That(scene.prefab.scene.IsValid(), Is.False, "the prefab asset is in no scene");

        SceneProbe.Log.Clear();
        UnityEngine.Object.Instantiate(scene.prefab);
        Assert.That(SceneProbe.Log, Is.EqualTo(new[] { "Thing(Clone) awake, target Thing(Clone)", "Thing(Clone) enabled" }));
    }

    [Test]
    public void AssetsAreLoadedOnceAndMayReferToEachOther()
    {
        string guidA = TemporaryProject.Guid("Assets/A.asset"), guidB = TemporaryProject.Guid("Assets/B.asset");
        string Asset(string other) => Start + $"--- !u!114 &11400000\nMonoBehaviour:\n  m_Script: {{fileID: 11500000, guid: {sample}, type: 3}}\n  number: 3\n  reference: {{fileID: 11400000, guid: {other}, type: 2}}\n";
        Project.Add("Assets/A.asset", Asset(guidB), "NativeFormatImporter:\n  mainObjectFileID: 11400000\n");
        Project.Add("Assets/B.asset", Asset(guidA), "NativeFormatImporter:\n  mainObjectFileID: 11400000\n");
        PlayScene(Object(1, "One", 11, 0, Probe(21, 1, $"  data: {{fileID: 11400000, guid: {guidA}, type: 2}}\n")));
        SerializedSample a = GameObject.Find("One").GetComponent<SceneProbe>().data!;
        Assert.That((a.name, a.number, a.reference!.name), Is.EqualTo(("A", 3, "B")));
        Assert.That(a.reference.reference, Is.SameAs(a));
    }

    [Test]
    public void MeshesOfModelsAndTextsAreFound()
    {
        string model = Project.Add("Assets/Model.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "ModelImporter:\n  animations:\n    isReadable: 1\n");
        string text = Project.Add("Assets/Text.txt", "words");
        PlayScene(Object(1, "One", 11, 0, Probe(21, 1, $"  mesh: {{fileID: -2432090755550338912, guid: {model}, type: 3}}\n  text: {{fileID: 4900000, guid: {text}, type: 3}}\n")));
        var probe = GameObject.Find("One").GetComponent<SceneProbe>();
        Assert.That((probe.mesh!.name, probe.mesh.vertexCount, probe.mesh.isReadable), Is.EqualTo(("default", 3, true)));
        Assert.That(probe.text!.text, Is.EqualTo("words"));
    }

    [Test]
    public void MissingThingsAreNamedOnceAndDoNotEndTheRun()
    {
        PlayScene(Object(1, "One", 11, 0, Probe(21, 1, "  target: {fileID: 77}\n  text: {fileID: 4900000, guid: 00000000000000000000000000000abc, type: 3}\n"))
            + "--- !u!114 &22\nMonoBehaviour:\n  m_GameObject: {fileID: 1}\n  m_Script: {fileID: 11500000, guid: 00000000000000000000000000000def, type: 3}\n"
            + "--- !u!7777 &23\nStrange:\n  m_GameObject: {fileID: 1}\n--- !u!7777 &24\nStrange:\n  m_GameObject: {fileID: 1}\n");
        Assert.That(SceneProbe.Log, Has.Count.EqualTo(2));
        Assert.That(Reports, Has.Count.EqualTo(4));
        Assert.That(Reports, Has.One.Contains("the class Strange (7777)").And.One.Contains("no asset has the GUID").And.One.Contains("fileID 77 is not in Assets/Main.unity").And.One.Contains("script with GUID"));
    }

    [Test]
    public void ReflectionProbesAndTheSkysReflection()
    {
        PlayScene(Object(1, "Hall", 11, 0,
                "--- !u!215 &21\nReflectionProbe:\n  m_GameObject: {fileID: 1}\n  m_Enabled: 1\n  m_Mode: 2\n  m_BoxSize: {x: 4, y: 3, z: 2}\n  m_BoxOffset: {x: 0, y: 1, z: 0}\n"
                + "  m_IntensityMultiplier: 0.5\n  m_Importance: 3\n  m_BoxProjection: 1\n  m_CustomBakedTexture: {fileID: 0}\n")
            + "--- !u!104 &2\nRenderSettings:\n  m_DefaultReflectionMode: 1\n  m_DefaultReflectionResolution: 64\n  m_ReflectionIntensity: 0.25\n");
        ReflectionProbe probe = GameObject.Find("Hall").GetComponent<ReflectionProbe>();
        Assert.That((probe.mode, probe.importance, probe.intensity, probe.boxProjection), Is.EqualTo((UnityEngine.Rendering.ReflectionProbeMode.Custom, 3, 0.5f, true)));
        Assert.That(probe.bounds, Is.EqualTo(new Bounds(new Vector3(1, 1, 0), new Vector3(4, 3, 2))));
        Assert.That((RenderSettings.defaultReflectionResolution, RenderSettings.reflectionIntensity), Is.EqualTo((64, 0.25f)));
        Assert.That(RenderSettings.defaultReflectionMode, Is.EqualTo(UnityEngine.Rendering.DefaultReflectionMode.Custom));
        Assert.That(Reports, Is.Empty);
    }
}
