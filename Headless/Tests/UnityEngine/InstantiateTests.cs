using NUnit.Framework;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Headless.Tests.UnityEngineApi;

public class InstantiateTests : EngineFixture
{
    [Test]
    public void ACopyHasItsOwnDataAndItsReferencesPointInside()
    {
        var original = new GameObject("A");
        original.transform.position = new Vector3(1f, 2f, 3f);
        var child = new GameObject("Child");
        child.transform.SetParent(original.transform, false);
        BoxCollider box = child.AddComponent<BoxCollider>();
        box.size = new Vector3(2f, 3f, 4f);
        CopySample data = original.AddComponent<CopySample>();
        data.target = child.transform;
        data.values = new[] { 1f, 2f };
        data.nested.points.Add(Vector3.one);
        data.SetHidden(7);
        data.notSaved = 9;

        GameObject copy = Object.Instantiate(original);
        CopySample copied = copy.GetComponent<CopySample>();
        Assert.That(copy.name, Is.EqualTo("A(Clone)"));
        Assert.That(copy.transform.position, Is.EqualTo(new Vector3(1f, 2f, 3f)));
        Assert.That(copied.target, Is.SameAs(copy.transform.GetChild(0)));
        Assert.That(copied.values, Is.EqualTo(data.values).And.Not.SameAs(data.values));
        Assert.That(copied.nested, Is.Not.SameAs(data.nested));
        Assert.That(copied.nested.points[0], Is.EqualTo(Vector3.one));
        Assert.That(copied.Hidden, Is.EqualTo(7));
        Assert.That(copied.notSaved, Is.Zero);
        Assert.That(copy.GetComponentInChildren<BoxCollider>().size, Is.EqualTo(new Vector3(2f, 3f, 4f)));
    }

    [Test]
    public void AwakeRunsOnTheFilledCopyBeforeInstantiateReturns()
    {
        var original = new GameObject("A");
        original.AddComponent<QuietProbe>();
        Take();
        Object.Instantiate(original, new Vector3(4f, 0f, 0f), Quaternion.identity);
        Assert.That(Take(), Is.EqualTo("A(Clone).Awake A(Clone).OnEnable"));
    }

    [Test]
    public void InstantiatingAComponentCopiesItsObjectAndReturnsTheComponent()
    {
        var parent = new GameObject("P");
        QuietProbe probe = new GameObject("A").AddComponent<QuietProbe>();
        QuietProbe copy = Object.Instantiate(probe, parent.transform);
        Assert.That(copy.transform.parent, Is.SameAs(parent.transform));
        Assert.That(copy, Is.Not.SameAs(probe));
    }

    [Test]
    public void AnInactiveOriginalGivesAnInactiveCopy()
    {
        var original = new GameObject("A");
        original.SetActive(false);
        original.AddComponent<QuietProbe>();
        GameObject copy = Object.Instantiate(original);
        Assert.That(copy.activeSelf, Is.False);
        Assert.That(Take(), Is.Empty);
    }

    [Test]
    public void ScriptableObjectsCopyDeeply()
    {
        var data = ScriptableObject.CreateInstance<DataSample>();
        data.name = "D";
        data.curve = new[] { 1, 2, 3 };
        DataSample copy = Object.Instantiate(data);
        Assert.That(copy.name, Is.EqualTo("D(Clone)"));
        Assert.That(copy.curve, Is.EqualTo(data.curve).And.Not.SameAs(data.curve));
        Object.DestroyImmediate(copy);
        Assert.That(copy == null, Is.True);
        Object.DestroyImmediate(data);
    }

    [Test]
    public void FindSeesActiveSceneObjectsOnly()
    {
        QuietProbe a = new GameObject("A").AddComponent<QuietProbe>();
        QuietProbe b = new GameObject("B").AddComponent<QuietProbe>();
        b.gameObject.SetActive(false);
        Assert.That(Object.FindObjectsByType<QuietProbe>(FindObjectsSortMode.None), Is.EqualTo(new[] { a }));
        Assert.That(Object.FindObjectsByType<QuietProbe>(FindObjectsInactive.Include, FindObjectsSortMode.InstanceID), Has.Length.EqualTo(2));
        Assert.That(Object.FindFirstObjectByType<QuietProbe>(), Is.SameAs(a));
        Assert.That(GameObject.Find("A"), Is.SameAs(a.gameObject));
        Assert.That(GameObject.Find("B") == null, Is.True);
        a.gameObject.hideFlags = HideFlags.HideAndDontSave;
        Assert.That(Object.FindFirstObjectByType<QuietProbe>() == null, Is.True);
        Assert.That(Resources.FindObjectsOfTypeAll<QuietProbe>(), Has.Length.EqualTo(2));
    }
}
