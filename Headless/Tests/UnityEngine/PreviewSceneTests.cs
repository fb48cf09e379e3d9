using NUnit.Framework;
using UnityEditor.SceneManagement;
using UnityEngine;
using UnityEngine.SceneManagement;
using Object = UnityEngine.Object;

namespace Headless.Tests.UnityEngineApi;

/// <summary>A scene apart, as a prefab is edited in: valid and loaded, yet unknown to searches, physics and the scene manager.</summary>
public class PreviewSceneTests : EngineFixture
{
    private Scene preview;
    private GameObject box = null!;

    [SetUp]
    public void Make()
    {
        preview = EditorSceneManager.NewPreviewScene();
        box = new GameObject("Box", typeof(BoxCollider));
        SceneManager.MoveGameObjectToScene(box, preview);
    }

    [TearDown]
    public void Close() => EditorSceneManager.ClosePreviewScene(preview);

    [Test]
    public void ItIsLoadedButNotListed()
    {
        Assert.That(preview.IsValid() && preview.isLoaded, Is.True);
        Assert.That(EditorSceneManager.IsPreviewScene(preview), Is.True);
        Assert.That(EditorSceneManager.IsPreviewSceneObject(box.transform), Is.True);
        for (int i = 0; i < SceneManager.sceneCount; i++) Assert.That(SceneManager.GetSceneAt(i), Is.Not.EqualTo(preview));
        Assert.That(preview.GetRootGameObjects(), Is.EqualTo(new[] { box }));
        Assert.That(box.activeInHierarchy, Is.True);
    }

    [Test]
    public void SearchesDoNotFindWhatIsInIt()
    {
        Assert.That(Object.FindObjectsByType<BoxCollider>(FindObjectsInactive.Include, FindObjectsSortMode.None), Is.Empty);
        Assert.That(GameObject.Find("Box") == null, Is.True);
    }

    [Test]
    public void ItsPhysicsAreItsOwn()
    {
        var hits = new Collider[4];
        Physics.SyncTransforms();
        Assert.That(Physics.CheckBox(Vector3.zero, Vector3.one), Is.False);
        Assert.That(preview.GetPhysicsScene().OverlapBox(Vector3.zero, Vector3.one, hits, Quaternion.identity), Is.EqualTo(1));
        Assert.That(preview.GetPhysicsScene(), Is.Not.EqualTo(Physics.defaultPhysicsScene));
        Assert.That(SceneManager.GetActiveScene().GetPhysicsScene().OverlapBox(Vector3.zero, Vector3.one, hits, Quaternion.identity), Is.Zero);
    }

    [Test]
    public void ClosingItDestroysWhatIsInIt()
    {
        Assert.That(EditorSceneManager.ClosePreviewScene(preview), Is.True);
        Assert.That(box == null, Is.True);
        Assert.That(preview.IsValid(), Is.False);
        Assert.That(EditorSceneManager.ClosePreviewScene(preview), Is.False);
    }
}
