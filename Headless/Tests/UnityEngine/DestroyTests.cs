using NUnit.Framework;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Headless.Tests.UnityEngineApi;

public class DestroyTests : EngineFixture
{
    [Test]
    public void DestroyWaitsForTheEndOfTheUpdateAndComesBeforeRendering()
    {
        var a = new GameObject("A");
        a.AddComponent<Probe>();
        Frame();
        Take();
        ActionProbe killer = ActionProbe.Create();
        killer.onUpdate = () => Object.Destroy(a);
        Headless.Engine.EngineHooks.RenderFrame = () => Calls.Add("render");
        Frame();
        Assert.That(Take(), Is.EqualTo("A.FixedUpdate A.FixedUpdate A.FixedUpdate A.FixedUpdate A.FixedUpdate A.Update A.LateUpdate A.OnDisable A.OnDestroy render"));
        Assert.That(a == null, Is.True);
    }

    [Test]
    public void ADestroyedObjectIsAliveUntilThenAndFakeNullAfter()
    {
        var a = new GameObject("A");
        Transform t = a.transform;
        Object.Destroy(a);
        Assert.That(a != null, Is.True);
        Frame();
        Assert.That(a == null, Is.True);
        Assert.That(t == null, Is.True);
        Assert.That(!a, Is.True);
        Assert.That((object)a is null, Is.False);
        Assert.That(a.Equals(null), Is.True);
        Assert.That(a.ToString(), Is.EqualTo("null"));
        Assert.Throws<MissingReferenceException>(() => _ = a.name);
        Assert.Throws<MissingReferenceException>(() => _ = t.position);
    }

    [Test]
    public void DestroyImmediateActsAtOnceOnTheWholeHierarchy()
    {
        var parent = new GameObject("P");
        parent.AddComponent<QuietProbe>();
        var child = new GameObject("C");
        child.transform.SetParent(parent.transform);
        child.AddComponent<QuietProbe>();
        Take();
        Object.DestroyImmediate(parent);
        Assert.That(Take(), Is.EqualTo("P.OnDisable C.OnDisable P.OnDestroy C.OnDestroy"));
        Assert.That(child == null, Is.True);
    }

    [Test]
    public void OnDestroyIsOnlySentToWhatWasAwake()
    {
        var a = new GameObject("A");
        a.SetActive(false);
        a.AddComponent<QuietProbe>();
        Object.DestroyImmediate(a);
        Assert.That(Take(), Is.Empty);
    }

    [Test]
    public void DestroyingAComponentLeavesTheRest()
    {
        var a = new GameObject("A");
        var probe = a.AddComponent<QuietProbe>();
        Take();
        Object.Destroy(probe);
        Frame();
        Assert.That(Take(), Is.EqualTo("A.Start A.OnDisable A.OnDestroy"));
        Assert.That(a != null && a.GetComponent<QuietProbe>() == null, Is.True);
    }

    [Test]
    public void DestroyWithDelayCountsScaledTime()
    {
        var a = new GameObject("A");
        Frame();
        Object.Destroy(a, 0.25f);
        Frame(2);
        Assert.That(a != null, Is.True);
        Frame();
        Assert.That(a == null, Is.True);
    }

    [Test]
    public void DestroyInEditModeIsAnErrorThatNamesTheCure()
    {
        Headless.Engine.EngineState.IsPlaying = false;
        var a = new GameObject("A");
        Object.Destroy(a);
        Assert.That(Console, Has.Some.Contains("Use DestroyImmediate instead"));
        Assert.That(a != null, Is.True);
        Headless.Engine.EngineState.IsPlaying = true;
    }

    [Test]
    public void AChildLeavesItsParentWhenItDies()
    {
        var parent = new GameObject("P");
        var child = new GameObject("C");
        child.transform.SetParent(parent.transform);
        Object.DestroyImmediate(child);
        Assert.That(parent.transform.childCount, Is.Zero);
        Assert.That(parent.scene.GetRootGameObjects(), Has.No.Member(child));
    }
}
