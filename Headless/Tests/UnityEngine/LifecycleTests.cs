using Headless.Engine;
using NUnit.Framework;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Headless.Tests.UnityEngineApi;

public class LifecycleTests : EngineFixture
{
    [Test]
    public void AddComponentSendsAwakeAndOnEnableAtOnceAndStartBeforeTheFirstUpdate()
    {
        new GameObject("A").AddComponent<Probe>();
        Assert.That(Take(), Is.EqualTo("A.Awake A.OnEnable"));
        Frame();
        Assert.That(Take(), Is.EqualTo("A.Start A.FixedUpdate A.Update A.LateUpdate"));
    }

    [Test]
    public void AnotherParentIsToldToAllScriptsBelow()
    {
        var parent = new GameObject("P");
        var child = new GameObject("C");
        child.transform.SetParent(parent.transform);
        ParentProbe near = parent.AddComponent<ParentProbe>(), below = child.AddComponent<ParentProbe>(), off = child.AddComponent<ParentProbe>();
        off.enabled = false;
        parent.transform.SetParent(new GameObject("New").transform);
        Assert.That((near.Times, below.Times, off.Times), Is.EqualTo((1, 1, 0)));
        parent.transform.SetParent(null);
        Assert.That((near.Times, below.Times, off.Times), Is.EqualTo((2, 2, 0)));
    }

    [Test]
    public void PrivateMessagesOfABaseClassAreFound()
    {
        new GameObject("A").AddComponent<DerivedProbe>();
        Frame();
        Assert.That(Take(), Does.StartWith("A.Awake A.OnEnable A.Start").And.EndWith("A.Update A.LateUpdate"));
    }

    [Test]
    public void AnInactiveObjectGetsNothingUntilItIsActivated()
    {
        var a = new GameObject("A");
        a.SetActive(false);
        a.AddComponent<QuietProbe>();
        Frame();
        Assert.That(Take(), Is.Empty);
        a.SetActive(true);
        Assert.That(Take(), Is.EqualTo("A.Awake A.OnEnable"));
        a.SetActive(false);
        a.SetActive(true);
        Assert.That(Take(), Is.EqualTo("A.OnDisable A.OnEnable"));
    }

    [Test]
    public void ADisabledComponentIsAwakeButNotEnabledOrStarted()
    {
        var prefab = new GameObject("A");
        prefab.SetActive(false);
        prefab.AddComponent<QuietProbe>().enabled = false;
        prefab.SetActive(true);
        Frame();
        Assert.That(Take(), Is.EqualTo("A.Awake"));
        prefab.GetComponent<QuietProbe>().enabled = true;
        Frame();
        Assert.That(Take(), Is.EqualTo("A.OnEnable A.Start"));
    }

    [TestCase(true, true, true)]
    [TestCase(true, false, false)]
    [TestCase(false, true, false)]
    [TestCase(false, false, false)]
    public void ActiveInHierarchyNeedsTheWholeChain(bool parentActive, bool childActive, bool expected)
    {
        var parent = new GameObject("P");
        var child = new GameObject("C");
        child.transform.SetParent(parent.transform);
        var probe = child.AddComponent<QuietProbe>();
        parent.SetActive(parentActive);
        child.SetActive(childActive);
        Assert.That(child.activeSelf, Is.EqualTo(childActive));
        Assert.That(child.activeInHierarchy, Is.EqualTo(expected));
        Assert.That(probe.isActiveAndEnabled, Is.EqualTo(expected));
    }

    [Test]
    public void DeactivatingAParentDisablesTheChildrenOnce()
    {
        var parent = new GameObject("P");
        var child = new GameObject("C");
        child.transform.SetParent(parent.transform);
        child.AddComponent<QuietProbe>();
        Take();
        parent.SetActive(false);
        child.SetActive(false);
        Assert.That(Take(), Is.EqualTo("C.OnDisable"));
        parent.SetActive(true);
        Assert.That(Take(), Is.Empty);
    }

    [Test]
    public void ReparentingUnderAnInactiveObjectDisables()
    {
        var parent = new GameObject("P");
        parent.SetActive(false);
        var child = new GameObject("C");
        child.AddComponent<QuietProbe>();
        Take();
        child.transform.SetParent(parent.transform);
        Assert.That(Take(), Is.EqualTo("C.OnDisable"));
    }

    [Test]
    public void ExecutionOrderSortsAwakeOfALoadedSceneAndUpdates()
    {
        SceneData scene = SceneTable.Create("S", "S.unity", loaded: false);
        Add(scene, "Late", typeof(Probe));
        Add(scene, "Early", typeof(EarlyProbe));
        ObjectFactory.Activate(scene);
        Assert.That(Take(), Is.EqualTo("Early.Awake Early.OnEnable Late.Awake Late.OnEnable"));
        Frame();
        Assert.That(Take(), Is.EqualTo("Early.Start Late.Start Early.FixedUpdate Late.FixedUpdate Early.Update Late.Update Early.LateUpdate Late.LateUpdate"));
    }

    static void Add(SceneData scene, string name, System.Type type) =>
        ObjectFactory.AddComponent(ObjectFactory.CreateGameObject(name, scene), type);

    [Test]
    public void AnObjectMadeInUpdateStartsBeforeLateUpdateOfTheSameFrame()
    {
        ActionProbe maker = ActionProbe.Create();
        maker.onUpdate = () =>
        {
            maker.onUpdate = null;
            new GameObject("N").AddComponent<Probe>();
        };
        Frame();
        Assert.That(Take(), Is.EqualTo("N.Awake N.OnEnable N.Start N.LateUpdate"));
    }

    [Test]
    public void AnExceptionIsLoggedWithItsObjectAndTheFrameGoesOn()
    {
        ActionProbe bad = ActionProbe.Create("Bad");
        bad.onUpdate = () => throw new System.InvalidOperationException("broken");
        new GameObject("Good").AddComponent<Probe>();
        Frame();
        Assert.That(Console, Has.Some.StartsWith("[Exception] InvalidOperationException: broken (Bad)"));
        Assert.That(Joined, Does.Contain("Good.Update Good.LateUpdate"));
    }

    [Test]
    public void LeavingPlayModeSendsQuitThenDisableThenDestroy()
    {
        new GameObject("A").AddComponent<Probe>();
        Frame();
        Take();
        Application.quitting += Note;
        PlaySession.End();
        Application.quitting -= Note;
        Assert.That(Take(), Is.EqualTo("A.Quit quitting A.OnDisable A.OnDestroy"));
    }

    static void Note() => Calls.Add("quitting");

    [Test]
    public void ANewComponentByConstructorIsRefusedWithAWarning()
    {
        var wrong = new ActionProbe();
        Assert.That(wrong == null, Is.True);
        Assert.That(Console, Has.Some.Contains("'new' keyword"));
    }

    [Test]
    public void RequireComponentAddsWhatIsMissingAndProtectsIt()
    {
        var a = new GameObject("A");
        a.AddComponent<NeedsBox>();
        Assert.That(a.GetComponent<BoxCollider>() != null, Is.True);
        Object.Destroy(a.GetComponent<BoxCollider>());
        Frame();
        Assert.That(a.GetComponent<BoxCollider>() != null, Is.True);
        Assert.That(Console, Has.Some.Contains("Can't remove BoxCollider because NeedsBox (Script) depends on it"));
    }

    [Test]
    public void DisallowMultipleComponentRefusesTheSecond()
    {
        var a = new GameObject("A");
        a.AddComponent<NeedsBox>();
        Assert.That(a.AddComponent<NeedsBox>() == null, Is.True);
        Assert.That(a.GetComponents<NeedsBox>(), Has.Length.EqualTo(1));
    }
}
