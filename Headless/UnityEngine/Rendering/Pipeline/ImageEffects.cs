using System.Collections.Generic;
using System.Reflection;
using System;
using UnityEngine;

namespace Headless.Engine;

/// <summary>The OnRenderImage chain of a camera.</summary>
internal static class ImageEffects
{
    private static readonly Type[] Parameters = [typeof(RenderTexture), typeof(RenderTexture)];

    public static List<(MonoBehaviour Script, MethodInfo Method)> Of(Camera camera)
    {
        var effects = new List<(MonoBehaviour, MethodInfo)>();
        foreach (MonoBehaviour script in camera.GetComponents<MonoBehaviour>())
        {
            if (CameraMessages.Runs(script) && script.ScriptType.Find("OnRenderImage", Parameters) is { } method)
            {
                effects.Add((script, method));
            }
        }

        return effects;
    }

    /// <summary>Runs the effects from one texture to the next; the last writes to the destination, null being the screen.</summary>
    public static void Run(Camera camera, RenderTexture picture, RenderTexture? destination, DrawTarget final)
    {
        FrameRenderer.FinalTarget = final;
        List<(MonoBehaviour Script, MethodInfo Method)> effects = Of(camera);
        RenderTexture source = picture;
        for (int i = 0; i < effects.Count; i++)
        {
            bool last = i == effects.Count - 1;
            RenderTexture? target = last
                ? destination
                : RenderTexture.GetTemporary(new RenderTextureDescriptor(picture.width, picture.height, RenderTextureFormat.ARGB32, 0));
            Call(effects[i].Script, effects[i].Method, source, target);
            if (source != picture)
            {
                RenderTexture.ReleaseTemporary(source);
            }

            source = target!;
        }

        if (effects.Count == 0)
        {
            Blitter.Blit(picture, final, null, 0, Vector2.one, Vector2.zero);
        }

        FrameRenderer.FinalTarget = null;
    }

    private static void Call(MonoBehaviour script, MethodInfo method, RenderTexture source, RenderTexture? target)
    {
        RenderTexture? active = RenderTexture.active;
        RenderTexture.active = target;
        try
        {
            method.Invoke(script, BindingFlags.DoNotWrapExceptions, null, [source, target], null);
        }
        catch (Exception exception)
        {
            Debug.LogException(exception, script);
        }

        RenderTexture.active = active;
        TargetState.Finish();
    }
}
