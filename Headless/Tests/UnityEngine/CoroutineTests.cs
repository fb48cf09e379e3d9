using System.Collections;
using NUnit.Framework;
using UnityEngine;

namespace Headless.Tests.UnityEngineApi;

public class CoroutineTests : EngineFixture
{
    [Test]
    public void RunsToTheFirstYieldAtOnceAndResumesBetweenUpdateAndLateUpdate()
    {
        ActionProbe probe = ActionProbe.Create();
        probe.onUpdate = () => Calls.Add("Update");
        probe.onLateUpdate = () => Calls.Add("LateUpdate");
        probe.StartCoroutine(Steps(2));
        Assert.That(Take(), Is.EqualTo("step0"));
        Frame();
        Assert.That(Take(), Is.EqualTo("Update step1 LateUpdate"));
    }

    [Test]
    public void StartedInUpdateDoesNotResumeInTheSameFrame()
    {
        ActionProbe probe = ActionProbe.Create();
        probe.onUpdate = () =>
        {
            probe.onUpdate = null;
            probe.StartCoroutine(Steps(2));
        };
        Frame();
        Assert.That(Take(), Is.EqualTo("step0"));
        Frame();
        Assert.That(Take(), Is.EqualTo("step1"));
    }

    static IEnumerator Steps(int count)
    {
        for (int i = 0; i < count; i++)
        {
            Calls.Add("step" + i);
            yield return null;
        }
    }

    [Test]
    public void EndOfFrameComesAfterRendering()
    {
        ActionProbe probe = ActionProbe.Create();
        Headless.Engine.EngineHooks.RenderFrame = () => Calls.Add("render");
        probe.StartCoroutine(EndOfFrames());
        Frame(2);
        Assert.That(Take(), Is.EqualTo("render end render end"));
    }

    static IEnumerator EndOfFrames()
    {
        while (true)
        {
            yield return new WaitForEndOfFrame();
            Calls.Add("end");
        }
    }

    [Test]
    public void WaitForSecondsFollowsScaledTime()
    {
        Frame();
        ActionProbe probe = ActionProbe.Create();
        probe.StartCoroutine(After(0.25f));
        Frame(2);
        Assert.That(Take(), Is.Empty);
        Time.timeScale = 0f;
        Frame(5);
        Assert.That(Take(), Is.Empty);
        Time.timeScale = 1f;
        Frame();
        Assert.That(Take(), Is.EqualTo("done"));
    }

    static IEnumerator After(float seconds)
    {
        yield return new WaitForSeconds(seconds);
        Calls.Add("done");
    }

    [Test]
    public void WaitForFixedUpdateResumesAfterTheFixedUpdates()
    {
        ActionProbe probe = ActionProbe.Create();
        Frame();
        probe.onFixedUpdate = () => Calls.Add("fixed");
        probe.onUpdate = () => Calls.Add("update");
        Time.fixedDeltaTime = 0.1f;
        probe.StartCoroutine(FixedSteps());
        Frame();
        Assert.That(Take(), Is.EqualTo("fixed resumed update"));
    }

    static IEnumerator FixedSteps()
    {
        yield return new WaitForFixedUpdate();
        Calls.Add("resumed");
    }

    [Test]
    public void NestedRoutinesResumeTheOuterWhenTheyEnd()
    {
        ActionProbe probe = ActionProbe.Create();
        probe.StartCoroutine(Outer(probe));
        Frame(3);
        Assert.That(Take(), Is.EqualTo("outer step0 step1 middle step0 end"));
    }

    static IEnumerator Outer(MonoBehaviour owner)
    {
        Calls.Add("outer");
        yield return Steps(2);
        Calls.Add("middle");
        yield return owner.StartCoroutine(Steps(1));
        Calls.Add("end");
    }

    [Test]
    public void CustomYieldInstructionsArePolledEachFrame()
    {
        bool open = false;
        ActionProbe probe = ActionProbe.Create();
        probe.StartCoroutine(Until(() => open));
        Frame(3);
        Assert.That(Take(), Is.Empty);
        open = true;
        Frame();
        Assert.That(Take(), Is.EqualTo("open"));
    }

    static IEnumerator Until(System.Func<bool> condition)
    {
        yield return new WaitUntil(condition);
        Calls.Add("open");
    }

    [Test]
    public void DisablingKeepsARoutineDeactivatingEndsIt()
    {
        ActionProbe probe = ActionProbe.Create();
        probe.StartCoroutine(Steps(10));
        probe.enabled = false;
        Frame();
        Assert.That(Take(), Is.EqualTo("step0 step1"));
        probe.gameObject.SetActive(false);
        probe.gameObject.SetActive(true);
        Frame(2);
        Assert.That(Take(), Is.Empty);
    }

    [Test]
    public void StopCoroutineTakesTheHandleOrTheRoutine()
    {
        ActionProbe probe = ActionProbe.Create();
        Coroutine first = probe.StartCoroutine(Steps(10));
        IEnumerator routine = Steps(10);
        probe.StartCoroutine(routine);
        Take();
        probe.StopCoroutine(first);
        Frame();
        Assert.That(Take(), Is.EqualTo("step1"));
        probe.StopCoroutine(routine);
        Frame();
        Assert.That(Take(), Is.Empty);
    }

    [Test]
    public void AnExceptionEndsTheRoutineAndIsLogged()
    {
        ActionProbe probe = ActionProbe.Create();
        probe.StartCoroutine(Failing());
        Frame(2);
        Assert.That(Console, Has.Some.StartsWith("[Exception] InvalidOperationException: in routine"));
    }

    static IEnumerator Failing()
    {
        yield return null;
        throw new System.InvalidOperationException("in routine");
    }

    [Test]
    public void StartOfAScriptMayBeARoutine()
    {
        new GameObject("R").AddComponent<RoutineStart>();
        Frame(2);
        Assert.That(Take(), Is.EqualTo("begin end"));
    }

    [Test]
    public void InvokeRepeatingKeepsItsRate()
    {
        Frame();
        var script = new GameObject("R").AddComponent<RoutineStart>();
        Take();
        script.InvokeRepeating("Tick", 0.1f, 0.05f);
        Frame();
        Calls.RemoveAll(c => c != "tick");
        Frame();
        Assert.That(Calls.FindAll(c => c == "tick"), Has.Count.GreaterThanOrEqualTo(2));
        script.CancelInvoke("Tick");
        Assert.That(script.IsInvoking(), Is.False);
    }
}
