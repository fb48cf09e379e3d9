using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;

namespace Headless.Tests.Rendering;

public sealed class ScriptableContextTests : ScriptableFixture
{
    private static readonly int Value = Shader.PropertyToID("_ScriptableContextValue");

    [Test]
    public void CommandsRunAtSubmitInTheirOrder()
    {
        Camera(new Vector3(0f, 0f, -5f), Vector3.zero);
        var seen = new List<float>();
        Use((context, _) =>
        {
            Run(context, c => c.SetGlobalFloat(Value, 1f));
            Run(context, c => c.SetGlobalFloat(Value, 2f));
            seen.Add(Shader.GetGlobalFloat(Value));
            context.Submit();
            seen.Add(Shader.GetGlobalFloat(Value));
        });
        Shader.SetGlobalFloat(Value, 0f);
        Frame();
        Assert.That(seen, Is.EqualTo(new[] { 0f, 2f }));
    }

    [Test]
    public void CommandsAreThoseOfTheCall()
    {
        Camera(new Vector3(0f, 0f, -5f), Vector3.zero);
        Use((context, _) =>
        {
            using var commands = new CommandBuffer();
            commands.SetGlobalFloat(Value, 3f);
            context.ExecuteCommandBuffer(commands);
            commands.Clear();
            commands.SetGlobalFloat(Value, 4f);
            context.Submit();
        });
        Frame();
        Assert.That(Shader.GetGlobalFloat(Value), Is.EqualTo(3f));
    }

    [Test]
    public void WhatIsNotSubmittedIsNotDrawn()
    {
        Camera(new Vector3(0f, 0f, -5f), Vector3.zero);
        Use((context, _) =>
        {
            Run(context, c => c.SetGlobalFloat(Value, 5f));
            context.Submit();
            Run(context, c => c.SetGlobalFloat(Value, 6f));
        });
        Frame(2);
        Assert.That(Shader.GetGlobalFloat(Value), Is.EqualTo(5f));
    }

    [Test]
    public void AContextAndItsListsEndWithTheFrame()
    {
        Camera(new Vector3(0f, 0f, -5f), Vector3.zero);
        ScriptableRenderContext kept = default;
        RendererList list = default;
        UseOne((context, camera, culled) =>
        {
            kept = context;
            list = List(context, culled, Drawing(camera, Unlit));
            Assert.That(context.QueryRendererListStatus(list), Is.EqualTo(RendererListStatus.kRendererListEmpty));
            Assert.That(context.QueryRendererListStatus(RendererList.nullRendererList), Is.EqualTo(RendererListStatus.kRendererListInvalid));
        });
        Frame();
        Assert.That(list.isValid, Is.False);
        Assert.Throws<InvalidOperationException>(() => kept.Submit());
    }

    [Test]
    public void AllCamerasComeInOneCallByDepthAndACameraAloneByItself()
    {
        Camera near = Camera(new Vector3(0f, 0f, -5f), Vector3.zero);
        Camera far = Camera(new Vector3(0f, 0f, -9f), Vector3.zero);
        (near.depth, far.depth) = (1f, -1f);
        var calls = new List<Camera[]>();
        Use((_, cameras) => calls.Add(cameras));
        Frame();
        near.Render();
        Assert.That(calls, Is.EqualTo(new[] { new[] { far, near }, [near] }));
    }

    [Test]
    public void CamerasSendNoMessagesAndRunNoCommandBuffersOfTheirOwn()
    {
        Camera camera = Camera(new Vector3(0f, 0f, -5f), Vector3.zero);
        using var commands = new CommandBuffer();
        commands.SetGlobalFloat(Value, 7f);
        camera.AddCommandBuffer(CameraEvent.BeforeForwardOpaque, commands);
        int called = 0;
        void Count(Camera _) => called++;
        UnityEngine.Camera.onPreCull += Count;
        UnityEngine.Camera.onPreRender += Count;
        UnityEngine.Camera.onPostRender += Count;
        Shader.SetGlobalFloat(Value, 0f);
        UseOne((_, _, _) => { });
        Frame();
        UnityEngine.Camera.onPreCull -= Count;
        UnityEngine.Camera.onPreRender -= Count;
        UnityEngine.Camera.onPostRender -= Count;
        Assert.That((called, Shader.GetGlobalFloat(Value)), Is.EqualTo((0, 0f)));
    }

    [Test]
    public void SetupCameraPropertiesSetsTheCamerasVariables()
    {
        Camera camera = Camera(new Vector3(1f, 2f, -5f), Vector3.zero);
        (camera.nearClipPlane, camera.farClipPlane) = (0.5f, 50f);
        UseOne((_, _, _) => { });
        Frame();
        Assert.That(Shader.GetGlobalVector("_WorldSpaceCameraPos"), Is.EqualTo(new Vector4(1f, 2f, -5f, 0f)));
        Assert.That(Shader.GetGlobalVector("_ProjectionParams"), Is.EqualTo(new Vector4(1f, 0.5f, 50f, 0.02f)));
        Assert.That(Shader.GetGlobalVector("_ScreenParams"), Is.EqualTo(new Vector4(128f, 96f, 1f + (1f / 128f), 1f + (1f / 96f))));
        Assert.That(Shader.GetGlobalMatrix("unity_CameraProjection"), Is.EqualTo(camera.projectionMatrix));
        Vector4[] planes = Shader.GetGlobalVectorArray("unity_CameraWorldClipPlanes")!;
        Assert.That(planes, Has.Length.EqualTo(6));
        Vector3 ahead = camera.transform.position + (camera.transform.forward * 0.5f);
        Assert.That(Vector3.Dot(planes[4], ahead) + planes[4].w, Is.Zero.Within(1e-4f), "the near plane");
    }

    [Test]
    public void RenderingFromWithinAPipelineIsRefused()
    {
        Camera camera = Camera(new Vector3(0f, 0f, -5f), Vector3.zero);
        Use((_, _) => camera.Render());
        Frame();
        Assert.That(TakeErrors().Single(), Does.Contain("Recursive rendering is not supported"));
    }
}
