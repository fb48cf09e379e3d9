using Headless.Engine;
using NUnit.Framework;
using UnityEngine;

namespace Headless.Tests.UnityEngineApi;

public class EditModeTests : EngineFixture
{
    [SetUp]
    public void EnterEditMode()
    {
        PlaySession.End();
        EngineState.IsEditor = true;
    }

    [Test]
    public void OnlyExecuteAlwaysScriptsReceiveMessages()
    {
        new GameObject("Plain").AddComponent<Probe>();
        new GameObject("Always").AddComponent<AlwaysProbe>();
        Frame();
        Assert.That(Take(), Is.EqualTo("Always.Reset Always.OnValidate Always.Awake Always.OnEnable Always.Start Always.Update"));
        Assert.That(Application.isPlaying, Is.False);
        Assert.That(Application.isEditor, Is.True);
    }
}
