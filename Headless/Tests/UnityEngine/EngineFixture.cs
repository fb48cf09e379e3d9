using System;
using System.Collections.Generic;
using Headless.Engine;
using NUnit.Framework;
using UnityEngine;

namespace Headless.Tests.UnityEngineApi;

/// <summary>Play mode in an empty scene with 0.1 s frames, a captured console and no drawing.</summary>
public abstract class EngineFixture
{
    Action? m_Render;
    Action? m_EndFrame;
    Action? m_BeginFrame;
    Action<LogType, string>? m_Console;

    protected List<string> Console { get; } = new();

    /// <summary>What the probes of a test wrote, in order.</summary>
    internal static List<string> Calls { get; } = new();

    [SetUp]
    public void EnterPlayMode()
    {
        (m_Render, m_EndFrame, m_BeginFrame, m_Console) = (EngineHooks.RenderFrame, EngineHooks.EndFrame, EngineHooks.BeginFrame, EngineHooks.Console);
        EngineHooks.RenderFrame = EngineHooks.EndFrame = EngineHooks.BeginFrame = null;
        EngineHooks.Console = (_, line) => Console.Add(line);
        Console.Clear();
        Calls.Clear();
        EngineState.Reset();
        EngineState.IsEditor = false;
        PlaySession.Begin(null);
        Time.captureDeltaTime = 0.1f;
    }

    [TearDown]
    public void LeavePlayMode()
    {
        PlaySession.End();
        EngineState.Reset();
        EngineState.IsPlaying = false;
        EngineState.IsEditor = false;
        (EngineHooks.RenderFrame, EngineHooks.EndFrame, EngineHooks.BeginFrame, EngineHooks.Console) = (m_Render, m_EndFrame, m_BeginFrame, m_Console);
    }

    protected static void Frame(int count = 1)
    {
        for (int i = 0; i < count; i++) PlayerLoop.RunFrame();
    }

    protected static string Joined => string.Join(" ", Calls);

    protected static string Take()
    {
        string text = Joined;
        Calls.Clear();
        return text;
    }
}
