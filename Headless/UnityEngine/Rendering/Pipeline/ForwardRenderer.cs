using System.Collections.Generic;
using UnityEngine.Rendering;
using UnityEngine;

namespace Headless.Engine;

/// <summary>The built-in forward pipeline for one camera.</summary>
internal sealed class ForwardRenderer
{
    private readonly ShadowMap shadows = new();
    private readonly DepthTexture depthTexture = new();
    private readonly CameraTargets targets = new();

    public void Render(Camera camera)
    {
        Camera.onPreCull?.Invoke(camera);
        CameraMessages.Send(camera, "OnPreCull");
        List<DrawRequest> all = SceneDraws.Collect();
        List<VisibleDraw> visible = SceneDraws.Visible(all, camera);
        Stereo.ForEachPass(camera, () => Render(camera, all, visible));
    }

    public void Reset()
    {
        shadows.Reset();
        depthTexture.Reset();
        targets.Reset();
    }

    private void Render(Camera camera, List<DrawRequest> all, List<VisibleDraw> visible)
    {
        Camera.onPreRender?.Invoke(camera);
        CameraMessages.Send(camera, "OnPreRender");

        LightSettings.Apply();
        ReflectionSettings.ApplyDefault();
        bool shadowed = shadows.Render(camera, all);
        depthTexture.Render(camera, visible);

        using CameraFrame frame = targets.Begin(camera);
        CameraSettings.Apply(camera);
        DrawScene(camera, frame, visible, shadowed);
        CameraMessages.SendToAll("OnRenderObject");
        CameraMessages.Send(camera, "OnPostRender");
        Camera.onPostRender?.Invoke(camera);
        RunEvent(camera, frame, CameraEvent.BeforeImageEffects);
        TargetState.Finish();
        targets.Finish(camera, frame);
        RunEvent(camera, frame, CameraEvent.AfterImageEffects);
        RunEvent(camera, frame, CameraEvent.AfterEverything);
        TargetState.Finish();
    }

    private static void DrawScene(Camera camera, CameraFrame frame, List<VisibleDraw> visible, bool shadowed)
    {
        RunEvent(camera, frame, CameraEvent.BeforeForwardOpaque);
        DrawAll(SceneDraws.Opaque(visible), shadowed);
        RunEvent(camera, frame, CameraEvent.AfterForwardOpaque);
        RunEvent(camera, frame, CameraEvent.BeforeImageEffectsOpaque);
        RunEvent(camera, frame, CameraEvent.AfterImageEffectsOpaque);
        RunEvent(camera, frame, CameraEvent.BeforeSkybox);
        if (camera.clearFlags == CameraClearFlags.Skybox)
        {
            Sky.Draw();
        }

        RunEvent(camera, frame, CameraEvent.AfterSkybox);
        RunEvent(camera, frame, CameraEvent.BeforeForwardAlpha);
        DrawAll(SceneDraws.Transparent(visible), shadowed);
        RunEvent(camera, frame, CameraEvent.AfterForwardAlpha);
    }

    private static void DrawAll(IEnumerable<VisibleDraw> draws, bool shadowed)
    {
        foreach (VisibleDraw visible in draws)
        {
            DrawRequest draw = visible.Request;
            ObjectLights lights = Lights(draw);
            LightSettings.ApplyBase(lights);
            GlobalKeywords.Set("SHADOWS_SCREEN", shadowed && draw.ReceiveShadows && lights.Main == LightList.Main);
            ReflectionSettings.Apply(draw.Reflections, draw.Bounds);
            PassSelection.DrawForward(draw, lights);
        }

        LightSettings.ApplyBase(ObjectLights.OfScene);
        ReflectionSettings.ApplyDefault();
        GlobalKeywords.Set("SHADOWS_SCREEN", false);
    }

    private static ObjectLights Lights(DrawRequest draw)
    {
        (bool lit, bool additive) = PassSelection.Lighting(draw.Material);
        if (!lit)
        {
            return ObjectLights.OfScene;
        }

        ObjectLights lights = ObjectLights.Of(draw, additive);
        LightReport.OfObject(draw, lights, additive);
        return lights;
    }

    private static void RunEvent(Camera camera, CameraFrame frame, CameraEvent when)
    {
        foreach (CommandBuffer buffer in camera.GetCommandBuffers(when))
        {
            buffer.Execute(frame.Target, frame.Temporaries);
            if (TargetState.Current != frame.Target)
            {
                TargetState.Set(frame.Target);
            }

            CameraSettings.Apply(camera);
        }
    }
}
