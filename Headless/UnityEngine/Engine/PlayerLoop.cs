using System;
using UnityEngine;

namespace Headless.Engine;

/// <summary>The frame: order as in Unity's "Order of execution for event functions".</summary>
static class PlayerLoop
{
    public static void RunFrame()
    {
        if (!EngineState.IsPlaying)
        {
            RunEditFrame();
            return;
        }
        FrameClock.BeginFrame();
        EngineHooks.BeginFrame?.Invoke();
        SceneLoading.RunPending();
        PhysicsWorld.ResetPoses();
        ScriptSchedule.RunStarts();
        while (FrameClock.StepFixed())
        {
            ScriptSchedule.FixedUpdate();
            if (Physics.simulationMode == SimulationMode.FixedUpdate) PhysicsWorld.Simulate(Time.fixedDeltaTime);
            CoroutineScheduler.Run(WaitKind.FixedUpdate);
            ScriptSchedule.RunStarts();
        }
        PhysicsWorld.Interpolate();
        ScriptSchedule.Update();
        if (Physics.simulationMode == SimulationMode.Update) PhysicsWorld.Simulate(Time.deltaTime);
        ScriptSchedule.RunStarts();
        ScriptSchedule.RunInvokes();
        CoroutineScheduler.Run(WaitKind.NextFrame);
        PlayableGraphs.Update();
        ScriptSchedule.LateUpdate();
        Destruction.Flush();
        Render();
        CoroutineScheduler.Run(WaitKind.EndOfFrame);
        Destruction.Flush();
        EndFrame();
    }

    static void RunEditFrame()
    {
        FrameClock.BeginFrame();
        EngineHooks.BeginFrame?.Invoke();
        EngineHooks.EditorUpdate?.Invoke();
        ScriptSchedule.RunStarts();
        ScriptSchedule.Update();
        CoroutineScheduler.Run(WaitKind.NextFrame);
        ScriptSchedule.LateUpdate();
        Render();
        EndFrame();
    }

    static void Render()
    {
        Application.SendBeforeRender();
        Guard(EngineHooks.RenderFrame);
        GuiMessages.Send();
    }

    static void EndFrame()
    {
        Guard(EngineHooks.EndFrame);
        ProfilerFrames.EndFrame();
    }

    static void Guard(Action? action)
    {
        try
        {
            action?.Invoke();
        }
        catch (Exception exception)
        {
            Debug.LogException(exception);
        }
    }
}
