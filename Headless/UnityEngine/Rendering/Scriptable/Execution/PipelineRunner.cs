using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace Headless.Engine;

/// <summary>Lets a scriptable pipeline record and submit, and leaves the drawing state as it was.</summary>
internal static class PipelineRunner
{
    private static readonly CameraTargets Targets = new();
    private static bool running;

    public static void Run(Action<ScriptableRenderContext> record)
    {
        if (running)
        {
            Debug.LogError("Recursive rendering is not supported in SRP (are you calling Camera.Render from within a render pipeline?).");
            return;
        }

        DrawTarget? target = TargetState.Current;
        (Matrix4x4 view, Matrix4x4 projection) = (ViewState.View, ViewState.Projection);
        (running, ViewState.FollowsTarget) = (true, false);
        TargetState.Set(null);
        GlobalProperties.Sheet.SetVector(BuiltinNames.LightShadowBias, default);
        ReflectionSettings.ApplyDefault();
        ObjectValues.Clear();
        var commands = new ContextCommands();
        try
        {
            record(new ScriptableRenderContext(commands));
        }
        catch (Exception problem)
        {
            Debug.LogException(problem);
        }
        finally
        {
            commands.Dispose();
            (Drawer.InvertCulling, Drawer.DepthBias) = (false, default);
            TargetState.Set(target);
            ViewState.Set(view, projection);
            (running, ViewState.FollowsTarget) = (false, true);
        }
    }

    /// <summary>The camera's texture, or the screen with its own depth.</summary>
    public static DrawTarget TargetOf(Camera camera) => Targets.Of(camera);

    public static void Reset() => Targets.Reset();
}
