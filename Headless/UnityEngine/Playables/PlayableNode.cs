using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Playables;

namespace Headless.Engine;

/// <summary>A playable in its graph: its clock, its inputs and the behaviour that is told of both.</summary>
sealed class PlayableNode
{
    readonly List<(PlayableNode? Node, float Weight)> m_Inputs = new();
    PlayState? m_Told;
    ulong m_Prepared;

    public PlayableNode(PlayableGraphState graph, Type type, IPlayableBehaviour? behaviour)
    {
        Graph = graph;
        Type = type;
        Behaviour = behaviour;
    }

    public PlayableGraphState Graph { get; }
    public Type Type { get; }
    public IPlayableBehaviour? Behaviour { get; }
    public bool IsAlive { get; private set; } = true;
    public PlayState State { get; set; } = PlayState.Playing;
    public double Speed { get; set; } = 1.0;
    public double Duration { get; set; } = double.MaxValue;
    public double PreviousTime { get; private set; }

    /// <summary>Whether the time was set since the last frame: the next shows that time and not a later one.</summary>
    public bool IsTimeSet { get; private set; }

    public double Time { get; private set; }

    public int InputCount
    {
        get => m_Inputs.Count;
        set
        {
            while (m_Inputs.Count < value) m_Inputs.Add(default);
            if (m_Inputs.Count > value) m_Inputs.RemoveRange(value, m_Inputs.Count - value);
        }
    }

    public PlayableNode? Input(int port) => m_Inputs[port].Node;
    public float Weight(int port) => m_Inputs[port].Weight;
    public void Connect(int port, PlayableNode? node) => m_Inputs[port] = (node, m_Inputs[port].Weight);
    public void SetWeight(int port, float weight) => m_Inputs[port] = (m_Inputs[port].Node, weight);

    public void SetTime(double time)
    {
        (PreviousTime, Time) = (Time, time);
        IsTimeSet = true;
    }

    /// <summary>From the top down: time goes on, then the behaviour may set up what is below it.</summary>
    public void Prepare(PlayableVisit above, float weight)
    {
        if (!IsAlive) return;
        PlayableVisit visit = above.At(this, weight);
        if (m_Prepared != visit.FrameId)
        {
            m_Prepared = visit.FrameId;
            if (visit.State == PlayState.Playing && !IsTimeSet) (PreviousTime, Time) = (Time, Time + visit.DeltaTime * (double)visit.Speed);
            IsTimeSet = false;
        }
        if (m_Told != visit.State)
        {
            m_Told = visit.State; // what never played is told that it is paused when it is first come by
            Call(visit.State == PlayState.Playing ? Message.Play : Message.Pause, visit);
        }
        if (visit.State == PlayState.Playing) Call(Message.Prepare, visit);
        for (int i = 0; i < m_Inputs.Count; i++) m_Inputs[i].Node?.Prepare(visit, m_Inputs[i].Weight);
    }

    /// <summary>From the bottom up: a mixer comes after what it mixes.</summary>
    public void Process(PlayableVisit above, float weight, UnityEngine.Object? data)
    {
        if (!IsAlive) return;
        PlayableVisit visit = above.At(this, weight);
        for (int i = 0; i < m_Inputs.Count; i++) m_Inputs[i].Node?.Process(visit, m_Inputs[i].Weight, data);
        if (visit.State == PlayState.Playing) Call(Message.Process, visit, data);
    }

    public void Create() => Call(Message.Create);

    public void StartGraph() => Call(Message.GraphStart);

    /// <summary>A graph that stops pauses what was playing; its own state is Playing still.</summary>
    public void StopPlaying(PlayableVisit frame)
    {
        if (m_Told == PlayState.Playing) Call(Message.Pause, frame);
        m_Told = null;
    }

    public void StopGraph() => Call(Message.GraphStop);

    public void Destroy()
    {
        if (!IsAlive) return;
        Call(Message.Destroy);
        IsAlive = false;
    }

    void Call(Message message, PlayableVisit visit = default, UnityEngine.Object? data = null)
    {
        if (Behaviour is null) return;
        var self = new Playable(new PlayableHandle(this));
        var info = new FrameData(visit);
        try
        {
            switch (message)
            {
                case Message.Create: Behaviour.OnPlayableCreate(self); break;
                case Message.GraphStart: Behaviour.OnGraphStart(self); break;
                case Message.Play: Behaviour.OnBehaviourPlay(self, info); break;
                case Message.Pause: Behaviour.OnBehaviourPause(self, info); break;
                case Message.Prepare: Behaviour.PrepareFrame(self, info); break;
                case Message.Process: Behaviour.ProcessFrame(self, info, data!); break;
                case Message.GraphStop: Behaviour.OnGraphStop(self); break;
                case Message.Destroy: Behaviour.OnPlayableDestroy(self); break;
            }
        }
        catch (Exception exception)
        {
            Debug.LogException(exception);
        }
    }

    enum Message { Create, GraphStart, Play, Pause, Prepare, Process, GraphStop, Destroy }
}
