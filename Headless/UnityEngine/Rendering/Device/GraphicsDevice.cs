using System.Collections.Concurrent;
using System;
using Headless.Shaders;
using Headless.Vulkan;
using UnityEngine;
using UnityEngine.Rendering;

namespace Headless.Engine;

/// <summary>The device that everything draws and computes on; the player opens it before the first scene.</summary>
internal static class GraphicsDevice
{
    private static readonly ConcurrentQueue<(string Kind, string Name, GpuBuffer Buffer)> Leaks = new();
    private static readonly ConcurrentQueue<GpuBuffer> Unused = new();
    private static GpuDevice? device;
    private static ShaderCompiler? compiler;

    public static bool IsReady => device is not null;

    public static GpuDevice Device => device ?? throw new InvalidOperationException(
        "There is no graphics device: GraphicsDevice.Initialize must run before anything is drawn or computed.");

    public static ShaderCompiler Compiler => compiler ?? throw new InvalidOperationException(
        "There is no shader compiler: GraphicsDevice.Initialize must run before anything is drawn or computed.");

    public static CommandRecorder Recorder => Device.Recorder;

    /// <summary>Opens the device and hangs drawing into the frame.</summary>
    public static void Initialize(GpuDeviceOptions options, ShaderCompiler shaderCompiler) =>
        Initialize(GpuDevice.Create(options), shaderCompiler);

    public static void Initialize(GpuDevice opened, ShaderCompiler shaderCompiler)
    {
        Shutdown();
        device = opened;
        ProfilerCounters.Set("Gfx Used Memory", static () => device?.AllocatedBytes ?? 0);
        compiler = shaderCompiler;
        MemoryPoison.Enabled = opened.Poisons;
        EngineHooks.RenderFrame = FrameRenderer.RenderFrame;
        EngineHooks.EndFrame = EndFrame;
        EngineHooks.FillPrimitive = BuiltinMeshes.FillPrimitive;
        EngineHooks.BuiltinResource = BuiltinResources.Find;
    }

    public static void Shutdown()
    {
        if (device is null)
        {
            return;
        }

        RenderPipelineManager.Reset();
        EngineHooks.RenderFrame = null;
        EngineHooks.EndFrame = null;
        EngineHooks.FillPrimitive = null;
        EngineHooks.BuiltinResource = null;
        AsyncReadbacks.Reset();
        ScreenTarget.Reset();
        Samplers.Reset();
        DefaultTextures.Reset();
        TemporaryTextures.Reset();
        BuiltinMeshes.Reset();
        BuiltinResources.Reset();
        ShaderLibrary.Reset();
        GlobalProperties.Sheet.Clear();
        GlobalKeywords.Clear();
        DrawQueue.Clear();
        RandomWriteTargets.Clear();
        LightReport.Reset();
        LightTextures.Reset();
        Blitter.Reset();
        FrameRenderer.Reset();
        Drawer.Reset();
        device.Dispose();
        MemoryPoison.Enabled = false;
        device = null;
        compiler = null;
    }

    /// <summary>Called from finalizers: the buffer is freed, and complained about, at the end of the frame.</summary>
    public static void ReportLeak(string kind, string name, GpuBuffer buffer) => Leaks.Enqueue((kind, name, buffer));

    /// <summary>Called from finalizers: the buffer is freed at the end of the frame.</summary>
    public static void FreeLater(GpuBuffer buffer) => Unused.Enqueue(buffer);

    /// <summary>Finds what scripts forgot to release without waiting for the garbage collector, as at the end of play.</summary>
    public static void FindLeaks()
    {
        GC.Collect();
        GC.WaitForPendingFinalizers();
        CollectLeaks();
    }

    /// <summary>Frees what scripts forgot to release, with Unity's warning.</summary>
    public static void CollectLeaks()
    {
        while (Leaks.TryDequeue(out (string Kind, string Name, GpuBuffer Buffer) leak))
        {
            Debug.LogWarning($"GarbageCollector disposing of {leak.Kind}. Please use {leak.Kind}.Release() or .Dispose() to manually release the buffer. Name: {leak.Name}");
            leak.Buffer.Dispose();
        }

        while (Unused.TryDequeue(out GpuBuffer? buffer))
        {
            buffer.Dispose();
        }
    }

    private static void EndFrame()
    {
        CollectLeaks();
        TemporaryTextures.EndFrame();
        Recorder.Submit();
        AsyncReadbacks.Update();
        GpuTimings.Collect();
    }
}
