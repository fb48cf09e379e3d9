using NUnit.Framework;
using UnityEngine;
using UnityEngine.Events;

namespace Headless.Tests.Importers;

/// <summary>Listeners of UnityEvents that were set in an inspector, as a scene has them.</summary>
public sealed class PersistentCallTests : SceneFixture
{
    private string script = "";

    [SetUp]
    public void SetUp()
    {
        EventProbe.Log.Clear();
        script = Project.Add("Assets/EventProbe.cs", "");
    }

    // Mode: 0 the event's own argument, 1 none, 2 object, 3 int, 4 float, 5 string, 6 bool. State: 0 off, 2 in play.
    private static string Call(string method, int mode, int target = 22, int state = 2) =>
        $"      - m_Target: {{fileID: {target}}}\n        m_TargetAssemblyTypeName: EventProbe, Assembly-CSharp\n        m_MethodName: {method}\n        m_Mode: {mode}\n"
        + "        m_Arguments:\n          m_ObjectArgument: {fileID: 1}\n          m_ObjectArgumentAssemblyTypeName: UnityEngine.Object, UnityEngine\n"
        + $"          m_IntArgument: 7\n          m_FloatArgument: 2.5\n          m_StringArgument: full\n          m_BoolArgument: 1\n        m_CallState: {state}\n";

    private EventProbe Play(string onFloat, string onNothing = "")
    {
        string Object(int id, string fields) =>
            $"--- !u!1 &{id}\nGameObject:\n  m_Component:\n  - component: {{fileID: {id + 10}}}\n  - component: {{fileID: {id + 20}}}\n  m_Name: Object {id}\n  m_IsActive: 1\n"
            + $"--- !u!4 &{id + 10}\nTransform:\n  m_GameObject: {{fileID: {id}}}\n  m_Father: {{fileID: 0}}\n"
            + $"--- !u!114 &{id + 20}\nMonoBehaviour:\n  m_GameObject: {{fileID: {id}}}\n  m_Enabled: 1\n  m_Script: {{fileID: 11500000, guid: {script}, type: 3}}\n{fields}";
        string Event(string name, string calls) => $"  {name}:\n    m_PersistentCalls:\n      m_Calls:{(calls == "" ? " []" : "")}\n{calls}";
        PlayScene(Object(1, Event("onFloat", onFloat) + Event("onNothing", onNothing)) + Object(2, ""));
        Assert.That(Reports, Is.Empty);
        return GameObject.Find("Object 1").GetComponent<EventProbe>();
    }

    [Test]
    public void EachKindOfArgumentArrives()
    {
        EventProbe probe = Play(Call("Float", 0) + Call("Nothing", 1) + Call("Thing", 2) + Call("Int", 3) + Call("Float", 4) + Call("Text", 5) + Call("Flag", 6));
        Assert.That(probe.onFloat.GetPersistentEventCount(), Is.EqualTo(7));
        Assert.That(probe.onFloat.GetPersistentTarget(0).name, Is.EqualTo("Object 2"));
        Assert.That(probe.onFloat.GetPersistentMethodName(1), Is.EqualTo("Nothing"));
        probe.onFloat.Invoke(0.25f);
        Assert.That(EventProbe.Log, Is.EqualTo(new[] { "Object 2 float 0.25", "Object 2 nothing", "Object 2 thing Object 1", "Object 2 int 7", "Object 2 float 2.5", "Object 2 text full", "Object 2 flag True" }));
    }

    [Test]
    public void TheyComeBeforeListenersFromCodeAndStayWhenThoseAreRemoved()
    {
        EventProbe probe = Play("", Call("Nothing", 1));
        probe.onNothing.AddListener(() => EventProbe.Log.Add("code"));
        probe.onNothing.Invoke();
        probe.onNothing.RemoveAllListeners();
        probe.onNothing.Invoke();
        Assert.That(EventProbe.Log, Is.EqualTo(new[] { "Object 2 nothing", "code", "Object 2 nothing" }));
    }

    [Test]
    public void ThoseThatAreOffOrHaveNoTargetOrNoMethodArePassedOver()
    {
        EventProbe probe = Play(Call("Nothing", 1, state: 0) + Call("Nothing", 1, target: 0) + Call("Nowhere", 1) + Call("Nothing", 1));
        Assert.That(probe.onFloat.GetPersistentListenerState(0), Is.EqualTo(UnityEventCallState.Off));
        probe.onFloat.Invoke(1f);
        Assert.That(EventProbe.Log, Is.EqualTo(new[] { "Object 2 nothing" }));
    }

    [Test]
    public void AnExceptionIsTheMethodsOwn()
    {
        EventProbe probe = Play("", Call("Fails", 1));
        Assert.That(() => probe.onNothing.Invoke(), Throws.InvalidOperationException.With.Message.EqualTo("as asked"));
    }
}
