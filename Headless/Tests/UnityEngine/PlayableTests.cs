using System;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Playables;

namespace Headless.Tests.UnityEngineApi;

public class PlayableTests : EngineFixture
{
    PlayableGraph m_Graph;

    [SetUp]
    public void CreateGraph()
    {
        m_Graph = PlayableGraph.Create("Test");
        m_Graph.SetTimeUpdateMode(DirectorUpdateMode.Manual);
    }

    [TearDown]
    public void DestroyGraph()
    {
        if (m_Graph.IsValid()) m_Graph.Destroy();
    }

    ScriptPlayable<PlayableProbe> Add(string name)
    {
        var playable = ScriptPlayable<PlayableProbe>.Create(m_Graph, new PlayableProbe { name = name });
        Take();
        return playable;
    }

    ScriptPlayableOutput Show<T>(T playable) where T : struct, IPlayable
    {
        var output = ScriptPlayableOutput.Create(m_Graph, "Output");
        output.SetSourcePlayable(playable);
        return output;
    }

    // A mixer with two inputs.
    ScriptPlayable<PlayableProbe> AddTree(out ScriptPlayable<PlayableProbe> first, out ScriptPlayable<PlayableProbe> second)
    {
        ScriptPlayable<PlayableProbe> root = Add("root");
        first = Add("first");
        second = Add("second");
        root.AddInput(first, 0, 1f);
        root.AddInput(second, 0, 0.5f);
        Show(root);
        return root;
    }

    [Test]
    public void FramesArePreparedFromTheTopAndProcessedFromTheBottom()
    {
        AddTree(out _, out _);
        m_Graph.Evaluate(0f);
        Assert.That(Take(), Is.EqualTo("root.start first.start second.start root.play root.prepare first.play first.prepare second.play second.prepare first.process second.process root.process"));
        m_Graph.Evaluate(1f);
        Assert.That(Take(), Is.EqualTo("root.prepare first.prepare second.prepare first.process second.process root.process"));
    }

    [Test]
    public void WithoutAnOutputNothingIsEvaluated()
    {
        ScriptPlayable<PlayableProbe> alone = Add("alone");
        m_Graph.Evaluate(1f);
        Assert.That((Take(), alone.GetTime()), Is.EqualTo(("alone.start", 0.0)));
    }

    [Test]
    public void TimeGoesOnWithTheSpeedsOfAllAbove()
    {
        ScriptPlayable<PlayableProbe> root = AddTree(out ScriptPlayable<PlayableProbe> first, out ScriptPlayable<PlayableProbe> second);
        root.SetSpeed(2.0);
        first.SetSpeed(-0.5);
        second.Pause();
        m_Graph.Evaluate(0.5f);
        m_Graph.Evaluate(0.25f);
        Assert.That((root.GetTime(), first.GetTime(), second.GetTime(), root.GetPreviousTime()), Is.EqualTo((1.5, -0.75, 0.0, 1.0)));
        root.Pause();
        m_Graph.Evaluate(1f);
        Assert.That((root.GetTime(), first.GetTime(), first.GetPlayState()), Is.EqualTo((1.5, -0.75, PlayState.Playing)));
    }

    [Test]
    public void ATimeThatWasSetIsShownBeforeItGoesOn()
    {
        ScriptPlayable<PlayableProbe> root = AddTree(out ScriptPlayable<PlayableProbe> first, out _);
        root.GetBehaviour().onPrepare = playable => ((ScriptPlayable<PlayableProbe>)playable.GetInput(0)).SetTime(10.0 + playable.GetTime());
        m_Graph.Evaluate(0.5f);
        Assert.That(first.GetTime(), Is.EqualTo(10.5), "as a Timeline sets the time of its clips");
        root.SetTime(3.0);
        m_Graph.Evaluate(0.5f);
        Assert.That((root.GetTime(), first.GetTime()), Is.EqualTo((3.0, 13.0)));
        m_Graph.Evaluate(0.5f);
        Assert.That((root.GetTime(), first.GetTime()), Is.EqualTo((3.5, 13.5)));
    }

    [Test]
    public void TwoOutputsOfOnePlayableAreOneFrameOfTime()
    {
        ScriptPlayable<PlayableProbe> shared = Add("shared");
        Show(shared);
        Show(shared);
        m_Graph.Evaluate(0.5f);
        Assert.That(shared.GetTime(), Is.EqualTo(0.5));
    }

    [Test]
    public void WhatIsPausedIsToldWhenTheGraphStarts()
    {
        ScriptPlayable<PlayableProbe> clip = Add("clip");
        clip.Pause();
        Show(clip);
        m_Graph.Play();
        m_Graph.Evaluate(0f);
        Assert.That(Take(), Is.EqualTo("clip.start clip.pause:Paused"));
        clip.Play();
        m_Graph.Evaluate(0f);
        clip.Pause();
        m_Graph.Evaluate(0f);
        Assert.That(Take(), Is.EqualTo("clip.play clip.prepare clip.process clip.pause:Paused"));
    }

    [Test]
    public void AStoppedGraphPausesWhatPlays()
    {
        AddTree(out _, out ScriptPlayable<PlayableProbe> second);
        second.Pause();
        m_Graph.Play();
        m_Graph.Evaluate(0f);
        Take();
        m_Graph.Stop();
        Assert.That(Take(), Is.EqualTo("root.pause:Playing first.pause:Playing root.stop first.stop second.stop"));
        Assert.That(m_Graph.IsPlaying(), Is.False);
        m_Graph.Stop();
        Assert.That(Take(), Is.Empty);
    }

    [Test]
    public void ADestroyedGraphStopsAndDestroysItsPlayables()
    {
        ScriptPlayable<PlayableProbe> clip = Add("clip");
        ScriptPlayableOutput output = Show(clip);
        m_Graph.Play();
        m_Graph.Evaluate(0f);
        Take();
        m_Graph.Destroy();
        Assert.That(Take(), Is.EqualTo("clip.pause:Playing clip.stop clip.destroy"));
        Assert.That((m_Graph.IsValid(), clip.IsValid(), clip.IsNull(), output.IsOutputValid(), clip.GetBehaviour()), Is.EqualTo((false, false, false, false, (PlayableProbe?)null)));
        Assert.That(() => clip.GetTime(), Throws.InvalidOperationException);
        Assert.That(() => m_Graph.Evaluate(), Throws.InvalidOperationException);
        Assert.That(() => Playable.Null.GetTime(), Throws.TypeOf<NullReferenceException>());
    }

    [Test]
    public void ADestroyedPlayableLeavesTheOthers()
    {
        ScriptPlayable<PlayableProbe> root = AddTree(out ScriptPlayable<PlayableProbe> first, out ScriptPlayable<PlayableProbe> second);
        first.Destroy();
        Assert.That(Take(), Is.EqualTo("first.destroy"));
        Assert.That((root.GetInput(0).IsNull(), root.GetInput(1).Equals((Playable)second), m_Graph.GetPlayableCount()), Is.EqualTo((true, true, 2)));
        m_Graph.Evaluate(0f);
        Assert.That(Take(), Does.Not.Contain("first").And.Contain("second.process"));
    }

    [Test]
    public void GameTimeEvaluatesBetweenUpdateAndLateUpdate()
    {
        ScriptPlayable<PlayableProbe> clip = Add("clip");
        Show(clip);
        m_Graph.SetTimeUpdateMode(DirectorUpdateMode.GameTime);
        m_Graph.Play();
        ActionProbe probe = ActionProbe.Create();
        Frame();
        Take();
        double before = clip.GetTime();
        probe.onUpdate = () => Calls.Add("Update");
        probe.onLateUpdate = () => Calls.Add("LateUpdate");
        Time.timeScale = 0.5f;
        Frame();
        Assert.That(Take(), Is.EqualTo("Update clip.prepare clip.process LateUpdate"));
        Assert.That(clip.GetTime() - before, Is.EqualTo(0.05).Within(1e-6));
        m_Graph.SetTimeUpdateMode(DirectorUpdateMode.Manual);
        Frame();
        m_Graph.SetTimeUpdateMode(DirectorUpdateMode.GameTime);
        m_Graph.Stop();
        Take();
        Frame();
        Assert.That(Take(), Is.EqualTo("Update LateUpdate"));
        Assert.That(() => m_Graph.SetTimeUpdateMode(DirectorUpdateMode.DSPClock), Throws.TypeOf<NotSupportedException>());
    }

    [Test]
    public void AnExceptionOfABehaviourIsLogged()
    {
        ScriptPlayable<PlayableProbe> clip = Add("clip");
        clip.GetBehaviour().onPrepare = _ => throw new InvalidOperationException("in a clip");
        Show(clip);
        m_Graph.Evaluate(0f);
        Assert.That(Console, Has.Some.StartsWith("[Exception] InvalidOperationException: in a clip"));
        Assert.That(Take(), Does.EndWith("clip.process"));
    }

    [Test]
    public void InputsKeepToTheirPorts()
    {
        ScriptPlayable<PlayableProbe> root = AddTree(out ScriptPlayable<PlayableProbe> first, out _);
        Assert.That((root.GetInputCount(), root.GetInputWeight(0), root.GetInputWeight(1)), Is.EqualTo((2, 1f, 0.5f)));
        Assert.That(m_Graph.Connect(first, 0, root, 1), Is.False);
        Assert.That(Console, Has.Some.Contains("connected already"));
        root.DisconnectInput(1);
        Assert.That(root.GetInput(1).IsNull());
        Assert.That(() => root.GetInput(2), Throws.TypeOf<IndexOutOfRangeException>());
    }

    [Test]
    public void APlayableIsOfItsBehavioursType()
    {
        Playable playable = Add("clip"), plain = Playable.Create(m_Graph, 2);
        Assert.That((playable.GetPlayableType(), plain.IsPlayableOfType<Playable>(), plain.GetInputCount()), Is.EqualTo((typeof(PlayableProbe), true, 2)));
        Assert.That(((ScriptPlayable<PlayableProbe>)playable).GetBehaviour().name, Is.EqualTo("clip"));
        Assert.That(() => (ScriptPlayable<PlayableProbe>)plain, Throws.TypeOf<InvalidCastException>());
    }

    [Test]
    public void AnExposedReferenceIsResolvedByTheTable()
    {
        PlayableTable table = new GameObject("Table").AddComponent<PlayableTable>();
        Transform byTable = table.transform, byDefault = new GameObject("Default").transform;
        var reference = new ExposedReference<Transform> { exposedName = "a", defaultValue = byDefault };
        m_Graph.SetResolver(table);
        Assert.That(reference.Resolve(m_Graph.GetResolver()), Is.SameAs(byDefault));
        table.SetReferenceValue("a", byTable);
        Assert.That(reference.Resolve(m_Graph.GetResolver()), Is.SameAs(byTable));
        table.SetReferenceValue("a", null!);
        Assert.That(reference.Resolve(table) == null, "a reference that was set to nothing");
        table.ClearReferenceValue("a");
        Assert.That(reference.Resolve(table), Is.SameAs(byDefault));
        Assert.That(reference.Resolve(null!), Is.SameAs(byDefault));
    }

    [Test]
    public void APropertyNameIsItsNumber()
    {
        PropertyName name = "Playback";
        Assert.That((name == new PropertyName("Playback"), name == "playback", name.Equals(new PropertyName(name.GetHashCode()))), Is.EqualTo((true, false, true)));
        Assert.That((PropertyName.IsNullOrEmpty(""), PropertyName.IsNullOrEmpty((string)null!), PropertyName.IsNullOrEmpty(name)), Is.EqualTo((true, true, false)));
        Assert.That((name.ToString(), new PropertyName(5).ToString()), Is.EqualTo(($"Playback:{name.GetHashCode()}", "Unknown:5")));
    }
}
