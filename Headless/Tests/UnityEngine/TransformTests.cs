using NUnit.Framework;
using UnityEngine;

namespace Headless.Tests.UnityEngineApi;

public class TransformTests : EngineFixture
{
    static void Near(Vector3 actual, Vector3 expected, float tolerance = 1e-4f) =>
        Assert.That((actual - expected).magnitude, Is.LessThan(tolerance), $"{actual.ToString("F6")} is not {expected.ToString("F6")}");

    static Transform Make(string name, Transform? parent = null)
    {
        Transform t = new GameObject(name).transform;
        if (parent is not null) t.SetParent(parent, false);
        return t;
    }

    [Test]
    public void WorldValuesFollowTheParents()
    {
        Transform parent = Make("P");
        Transform child = Make("C", parent);
        parent.SetPositionAndRotation(new Vector3(1f, 0f, 0f), Quaternion.Euler(0f, 90f, 0f));
        parent.localScale = new Vector3(2f, 2f, 2f);
        child.localPosition = Vector3.forward;
        Near(child.position, new Vector3(3f, 0f, 0f));
        Near(child.forward, Vector3.right);
        Near(child.lossyScale, Vector3.one * 2f);
        Near(child.InverseTransformPoint(child.TransformPoint(new Vector3(1f, 2f, 3f))), new Vector3(1f, 2f, 3f));
        Near(child.TransformDirection(Vector3.forward), Vector3.right);
        Near(child.TransformVector(Vector3.forward), Vector3.right * 2f);
    }

    [Test]
    public void SettingWorldPositionAndRotationUnderAParent()
    {
        Transform parent = Make("P");
        parent.SetPositionAndRotation(new Vector3(1f, 2f, 3f), Quaternion.Euler(10f, 20f, 30f));
        parent.localScale = new Vector3(1f, 2f, 3f);
        Transform child = Make("C", parent);
        child.position = new Vector3(-4f, 5f, 6f);
        child.rotation = Quaternion.Euler(40f, 50f, 60f);
        Near(child.position, new Vector3(-4f, 5f, 6f));
        Assert.That(Quaternion.Angle(child.rotation, Quaternion.Euler(40f, 50f, 60f)), Is.LessThan(0.1f));
    }

    [Test]
    public void SetParentKeepsTheWorldPlaceUnlessAsked()
    {
        Transform parent = Make("P");
        parent.SetPositionAndRotation(new Vector3(1f, 2f, 3f), Quaternion.Euler(0f, 90f, 0f));
        parent.localScale = Vector3.one * 2f;
        Transform a = Make("A");
        a.position = new Vector3(5f, 0f, 0f);
        a.SetParent(parent);
        Near(a.position, new Vector3(5f, 0f, 0f));
        Near(a.localScale, Vector3.one * 0.5f);
        Near(a.eulerAngles, Vector3.zero, 0.01f);
        a.SetParent(null, false);
        Near(a.localScale, Vector3.one * 0.5f);
        Near(a.position, a.localPosition);
    }

    [Test]
    public void AMirroredParentMirrorsRotation()
    {
        Transform parent = Make("P");
        parent.localScale = new Vector3(-1f, 1f, 1f);
        Transform child = Make("C", parent);
        child.localRotation = Quaternion.Euler(0f, 30f, 0f);
        Near(child.forward, parent.TransformVector(child.localRotation * Vector3.forward));
        child.rotation = Quaternion.Euler(0f, 30f, 0f);
        Near(child.eulerAngles, new Vector3(0f, 30f, 0f), 0.01f);
    }

    [Test]
    public void ChildrenAreListedFoundAndOrdered()
    {
        Transform parent = Make("P");
        Transform a = Make("A", parent), b = Make("B", parent), c = Make("C", b);
        Assert.That(parent.childCount, Is.EqualTo(2));
        Assert.That(parent.GetChild(1), Is.SameAs(b));
        Assert.That(parent.Find("B/C"), Is.SameAs(c));
        Assert.That(c.root, Is.SameAs(parent));
        Assert.That(c.IsChildOf(parent), Is.True);
        b.SetAsFirstSibling();
        Assert.That(a.GetSiblingIndex(), Is.EqualTo(1));
        var names = new System.Collections.Generic.List<string>();
        foreach (Transform child in parent) names.Add(child.name);
        Assert.That(names, Is.EqualTo(new[] { "B", "A" }));
        Assert.Throws<UnityException>(() => parent.GetChild(2));
    }

    [Test]
    public void HasChangedReachesTheChildren()
    {
        Transform parent = Make("P");
        Transform child = Make("C", parent);
        _ = child.localToWorldMatrix;
        child.hasChanged = false;
        parent.position = Vector3.one;
        Assert.That(child.hasChanged, Is.True);
    }

    [Test]
    public void RotateAroundAndLookAt()
    {
        Transform t = Make("T");
        t.position = Vector3.right;
        t.RotateAround(Vector3.zero, Vector3.up, 90f);
        Near(t.position, Vector3.back);
        t.LookAt(Vector3.zero);
        Near(t.forward, Vector3.forward);
    }

    [Test]
    public void GetComponentsWalksParentsAndChildren()
    {
        Transform parent = Make("P");
        Transform child = Make("C", parent);
        BoxCollider box = child.gameObject.AddComponent<BoxCollider>();
        Assert.That(parent.GetComponentInChildren<Collider>(), Is.SameAs(box));
        Assert.That(child.GetComponentInParent<Transform>(), Is.SameAs(child));
        Assert.That(parent.GetComponentsInChildren<Transform>(), Has.Length.EqualTo(2));
        child.gameObject.SetActive(false);
        Assert.That(parent.GetComponentInChildren<Collider>() == null, Is.True);
        Assert.That(parent.GetComponentInChildren<Collider>(true), Is.SameAs(box));
        Assert.That(parent.TryGetComponent(out BoxCollider none), Is.False);
        Assert.That(none == null, Is.True);
    }
}
