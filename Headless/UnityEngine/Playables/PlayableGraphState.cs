using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Playables;

namespace Headless.Engine;

/// <summary>A graph of playables: what it owns, and the walks from its outputs in each evaluation.</summary>
sealed class PlayableGraphState
{
    readonly List<PlayableNode> m_Playables = new();
    readonly List<PlayableOutputState> m_Outputs = new();
    DirectorUpdateMode m_UpdateMode = DirectorUpdateMode.GameTime;
    bool m_Started;
    ulong m_Frame;

    public PlayableGraphState(string name) => Name = name;

    public string Name { get; }
    public bool IsValid { get; private set; } = true;
    public bool IsPlaying { get; private set; }
    public IExposedPropertyTable? Resolver { get; set; }
    public int PlayableCount => m_Playables.Count;
    public int OutputCount => m_Outputs.Count;

    public DirectorUpdateMode UpdateMode
    {
        get => m_UpdateMode;
        set => m_UpdateMode = value != DirectorUpdateMode.DSPClock ? value : throw new NotSupportedException("There is no sound here, so a graph cannot follow its clock.");
    }

    public PlayableNode Add(Type type, IPlayableBehaviour? behaviour, int inputs)
    {
        var node = new PlayableNode(this, type, behaviour) { InputCount = inputs };
        m_Playables.Add(node);
        node.Create();
        if (m_Started) node.StartGraph();
        return node;
    }

    public PlayableOutputState AddOutput(string name)
    {
        var output = new PlayableOutputState(this, name);
        m_Outputs.Add(output);
        return output;
    }

    public void Remove(PlayableNode node)
    {
        if (!m_Playables.Remove(node)) return;
        node.Destroy();
        foreach (PlayableNode other in m_Playables)
            for (int i = 0; i < other.InputCount; i++)
                if (other.Input(i) == node) other.Connect(i, null);
        foreach (PlayableOutputState output in m_Outputs)
            if (output.Source == node) output.Source = null;
    }

    public void Play()
    {
        if (IsPlaying) return;
        IsPlaying = true;
        PlayableGraphs.Add(this);
        Start();
    }

    public void Stop()
    {
        if (IsPlaying) PlayableGraphs.Remove(this);
        IsPlaying = false;
        if (!m_Started) return;
        m_Started = false;
        foreach (PlayableNode node in m_Playables.ToArray()) node.StopPlaying(Frame(0f, FrameData.EvaluationType.Playback));
        foreach (PlayableNode node in m_Playables.ToArray()) node.StopGraph();
    }

    public void Evaluate(float deltaTime, FrameData.EvaluationType evaluation)
    {
        Start();
        m_Frame++;
        PlayableVisit frame = Frame(deltaTime, evaluation);
        for (int i = 0; i < m_Outputs.Count; i++) m_Outputs[i].Source?.Prepare(At(frame, m_Outputs[i]), 1f);
        for (int i = 0; i < m_Outputs.Count; i++) m_Outputs[i].Source?.Process(At(frame, m_Outputs[i]), 1f, m_Outputs[i].UserData);
    }

    public void Destroy()
    {
        Stop();
        foreach (PlayableNode node in m_Playables.ToArray()) node.Destroy();
        m_Playables.Clear();
        m_Outputs.Clear();
        IsValid = false;
    }

    void Start()
    {
        if (m_Started) return;
        m_Started = true;
        foreach (PlayableNode node in m_Playables.ToArray()) node.StartGraph();
    }

    static PlayableVisit At(PlayableVisit frame, PlayableOutputState output) =>
        frame with { Output = new PlayableOutputHandle(output), EffectiveWeight = output.Weight };

    PlayableVisit Frame(float deltaTime, FrameData.EvaluationType evaluation) => new()
    {
        FrameId = m_Frame,
        DeltaTime = deltaTime,
        Evaluation = evaluation,
        Weight = 1f,
        EffectiveWeight = 1f,
        ParentSpeed = 1f,
        Speed = 1f,
        State = PlayState.Playing,
    };
}
