using Headless.Engine;
using NUnit.Framework;
using UnityEditor;
using UnityEditor.SceneManagement;
using UnityEngine;
using UnityEngine.Rendering.Universal;
using UnityEngine.SceneManagement;
using Object = UnityEngine.Object;

namespace Headless.Tests.Importers;

/// <summary>A scene that is saved is the same when it is opened again.</summary>
public sealed class SceneWriterTests : SceneFixture
{
    private const string Saved = "Assets/Saved.unity";

    [SetUp]
    public void SetUp()
    {
        SceneProbe.Log.Clear();
        Project.Add("Assets/SceneProbe.cs", "");
        Project.Add("Assets/Words.txt", "words");
        PlayScene("--- !u!29 &1\nOcclusionCullingSettings:\n  m_ObjectHideFlags: 0\n");
        PlaySession.End();
        EditorSceneManager.NewScene(NewSceneSetup.DefaultGameObjects);
    }

    [Test]
    public void HierarchyPlacesAndComponentsComeBack()
    {
        var cube = new GameObject("It's: \"odd\" # 1", typeof(MeshFilter), typeof(MeshRenderer), typeof(BoxCollider)) { layer = 5 };
        cube.GetComponent<MeshFilter>().sharedMesh = Resources.GetBuiltinResource<Mesh>("Cube.fbx");
        cube.GetComponent<MeshRenderer>().sharedMaterial = Resources.GetBuiltinResource<Material>("Default-Material.mat");
        cube.GetComponent<BoxCollider>().size = new Vector3(0.1f, 2f, 1e-7f);
        var child = new GameObject("Child");
        child.transform.SetParent(cube.transform);
        child.transform.SetLocalPositionAndRotation(new Vector3(1f / 3f, -2f, 3e9f), Quaternion.Euler(10f, 20f, 30f));
        child.transform.localScale = new Vector3(1f, 2f, 3f);
        child.SetActive(false);
        Quaternion turn = child.transform.localRotation;
        Reopen();
        cube = Roots().Single(g => g.layer == 5);
        Assert.That(Roots().Select(g => g.name), Is.EqualTo(new[] { "Main Camera", "Directional Light", "It's: \"odd\" # 1" }));
        Assert.That(cube.GetComponent<BoxCollider>().size, Is.EqualTo(new Vector3(0.1f, 2f, 1e-7f)));
        Assert.That(cube.GetComponent<MeshFilter>().sharedMesh, Is.SameAs(Resources.GetBuiltinResource<Mesh>("Cube.fbx")));
        Assert.That(cube.GetComponent<MeshRenderer>().sharedMaterials, Is.EqualTo(new[] { Resources.GetBuiltinResource<Material>("Default-Material.mat") }));
        Transform below = cube.transform.GetChild(0);
        Assert.That((below.name, below.localPosition, below.localRotation, below.localScale, below.gameObject.activeSelf),
            Is.EqualTo(("Child", new Vector3(1f / 3f, -2f, 3e9f), turn, new Vector3(1f, 2f, 3f), false)));
    }

    [Test]
    public void ComponentsOfUnitysPackagesComeBack()
    {
        Camera.main.GetUniversalAdditionalCameraData();
        Reopen();
        Assert.That(Camera.main.GetComponent<UniversalAdditionalCameraData>(), Is.Not.Null);
    }

    [Test]
    public void CameraLightAndSkyComeBack()
    {
        Camera.main.fieldOfView = 33f;
        Camera.main.cullingMask = 5;
        RenderSettings.ambientIntensity = 0.5f;
        Reopen();
        Assert.That((Camera.main.fieldOfView, Camera.main.cullingMask, Camera.main.transform.position), Is.EqualTo((33f, 5, new Vector3(0f, 1f, -10f))));
        Light light = Object.FindObjectsByType<Light>(FindObjectsSortMode.None).Single();
        Assert.That((light.type, light.shadows, light.color), Is.EqualTo((LightType.Directional, LightShadows.Soft, new Color(1f, 0.95686275f, 0.8392157f))));
        Assert.That(RenderSettings.ambientIntensity, Is.EqualTo(0.5f));
        Assert.That(RenderSettings.skybox, Is.SameAs(Resources.GetBuiltinResource<Material>("Default-Skybox.mat")));
    }

    [Test]
    public void ScriptsAndTheirReferencesComeBack()
    {
        var probe = new GameObject("Probe").AddComponent<SceneProbe>();
        probe.target = Camera.main.transform;
        probe.prefab = Camera.main.gameObject;
        probe.text = AssetDatabase.LoadAssetAtPath<TextAsset>("Assets/Words.txt");
        probe.mesh = new Mesh { hideFlags = HideFlags.HideAndDontSave };
        probe.exposed = new ExposedReference<Transform> { exposedName = "0123: a name", defaultValue = Camera.main.transform };
        probe.enabled = false;
        Reopen();
        probe = Object.FindObjectsByType<SceneProbe>(FindObjectsInactive.Include, FindObjectsSortMode.None).Single();
        Assert.That((probe.target, probe.prefab, probe.enabled), Is.EqualTo((Camera.main.transform, Camera.main.gameObject, false)));
        Assert.That((probe.exposed.exposedName, probe.exposed.Resolve(null!)), Is.EqualTo((new PropertyName("0123: a name"), Camera.main.transform)));
        Assert.That(probe.text!.text, Is.EqualTo("words"));
        Assert.That(probe.mesh == null, "what is not to be saved");
    }

    [Test]
    public void WhatIsNotToBeSavedIsNot()
    {
        _ = new GameObject("Passing") { hideFlags = HideFlags.DontSave };
        Reopen();
        Assert.That(Roots().Select(g => g.name), Has.None.EqualTo("Passing"));
    }

    [Test]
    public void AComponentThatCannotBeWrittenIsNamed()
    {
        new GameObject("Wheel").AddComponent<WheelCollider>();
        Assert.That(() => EditorSceneManager.SaveScene(SceneManager.GetActiveScene(), Saved),
            Throws.InstanceOf<NotSupportedException>().With.Message.Contains("'Wheel' has a WheelCollider"));
    }

    private void Reopen()
    {
        Assert.That(EditorSceneManager.SaveScene(SceneManager.GetActiveScene(), Saved));
        EditorSceneManager.NewScene(NewSceneSetup.EmptyScene);
        EditorSceneManager.OpenScene(Saved);
        Assert.That(Reports, Is.Empty);
    }

    private static GameObject[] Roots() => SceneManager.GetActiveScene().GetRootGameObjects();
}
