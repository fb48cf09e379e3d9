using Headless.Engine;
using Headless.Player;
using Headless.Tests.Fuzz;
using Headless.Tests.Rendering;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering.Universal;

namespace Headless.Tests.Player;

/// <summary>A sample's water, scenery and sky in two eyes, against cameras of one picture at their places in the same frame.</summary>
[Category("Gpu")]
public sealed class StereoSampleTests
{
    private const string Sample = "Packages/com.sphfluid/Samples~/GettingStarted/GettingStarted.unity";

    // Shadow maps are fitted to a camera's view, which two cameras do not share, and slices have one sample.
    [Test]
    public void EachEyeSeesWhatACameraThereSees(
        [Values(PipelineChoice.BuiltIn, PipelineChoice.Universal)] string pipeline, [Values(StereoChoice.MultiPass, StereoChoice.Instanced)] string how)
    {
        var said = new List<string>();
        using EngineSession session = EngineSession.Start(
            FuzzProject.Repository, Path.Combine(FuzzProject.Repository, "Build/ScriptAssemblies"), null, false,
            (type, line) => { if (type is LogType.Error or LogType.Exception or LogType.Assert) said.Add(line); }, pipeline);
        ScreenTarget.Resize(320, 120);
        Time.captureDeltaTime = 1f / 30f;
        StereoChoice.Apply(how);
        PlaySession.Begin(Sample, session.Assemblies);
        foreach (Light light in UnityEngine.Object.FindObjectsByType<Light>(FindObjectsSortMode.None)) light.shadows = LightShadows.None;
        if (UniversalRenderPipeline.asset is { } asset) asset.msaaSampleCount = 1;
        Camera camera = Camera.main!;
        (camera.stereoSeparation, camera.stereoConvergence) = (0.1f, 2f);
        var eyes = new EyeCameras(camera);
        for (int frame = 0; frame < 4; frame++) PlayerLoop.RunFrame();
        eyes.AssertAlike($"sample-{pipeline}-{how}", 0.005);
        Assert.That(said, Is.Empty);
    }
}
