using Headless.Engine;
using Headless.Shaders;
using Headless.Vulkan;
using NUnit.Framework;
using UnityEngine;

namespace Headless.Tests.Rendering;

/// <summary>Play mode in an empty scene with a graphics device under the validation layer; console errors fail the test unless taken.</summary>
public abstract class RenderFixture
{
    private readonly List<string> errors = [];
    private readonly List<string> warnings = [];
    private string folder = string.Empty;
    private int messagesBefore;
    private Action<LogType, string>? console;

    [OneTimeSetUp]
    public void OpenDevice()
    {
        folder = Path.Combine(Path.GetTempPath(), $"headless-rendering-{Guid.NewGuid():N}");
        Directory.CreateDirectory(folder);
        string cache = Path.Combine(Path.GetTempPath(), "headless-rendering-shaders");
        GraphicsDevice.Initialize(Options, new ShaderCompiler(cache, new IncludeResolver(folder)));
    }

    [OneTimeTearDown]
    public void CloseDevice()
    {
        GraphicsDevice.Shutdown();
        Directory.Delete(folder, true);
    }

    [SetUp]
    public void EnterPlayMode()
    {
        console = EngineHooks.Console;
        EngineHooks.Console = (type, line) =>
        {
            if (type is LogType.Error or LogType.Exception or LogType.Assert)
            {
                errors.Add(line);
            }
            else if (type == LogType.Warning)
            {
                warnings.Add(line);
            }
        };
        errors.Clear();
        warnings.Clear();
        messagesBefore = GraphicsDevice.Device.ValidationMessages.Count;
        EngineState.Reset();
        EngineState.IsEditor = false;
        PlaySession.Begin(null);
        Time.captureDeltaTime = 0.1f;
        RenderSettings.Reset();
        ScreenTarget.Resize(128, 96);
    }

    [TearDown]
    public void LeavePlayMode()
    {
        PlaySession.End();
        EngineState.Reset();
        EngineState.IsPlaying = false;
        EngineHooks.Console = console;
        GraphicsDevice.Device.WaitIdle();
        Assert.Multiple(() =>
        {
            Assert.That(GraphicsDevice.Device.ValidationMessages.Skip(messagesBefore), Is.Empty, "validation messages");
            Assert.That(errors, Is.Empty, "console errors");
        });
    }

    protected virtual GpuDeviceOptions Options => new() { Adapter = Environment.GetEnvironmentVariable("VULKAN_TEST_DEVICE"), Validate = true };

    protected IReadOnlyList<string> Warnings => warnings;

    /// <summary>The console's errors so far; they no longer fail the test.</summary>
    protected string[] TakeErrors()
    {
        string[] taken = [.. errors];
        errors.Clear();
        return taken;
    }

    protected static void Frame(int count = 1)
    {
        for (int i = 0; i < count; i++)
        {
            PlayerLoop.RunFrame();
        }
    }

    protected ComputeShader Compute(string source, string name = "Test")
    {
        string path = Path.Combine(folder, $"{name}-{Guid.NewGuid():N}.compute");
        File.WriteAllText(path, source);
        return new ComputeShader(ComputeSource.Parse(path, GraphicsDevice.Compiler.Includes)) { name = name };
    }

    protected Shader ShaderOf(string source) =>
        new(ShaderLabSource.ParseText(Path.Combine(folder, "Test.shader"), source, GraphicsDevice.Compiler.Includes));

    protected Material MaterialOf(string source) => new(ShaderOf(source));

    protected static GraphicsBuffer Floats(params float[] values)
    {
        var buffer = new GraphicsBuffer(GraphicsBuffer.Target.Structured, values.Length, sizeof(float));
        buffer.SetData(values);
        return buffer;
    }

    protected static float[] Read(GraphicsBuffer buffer)
    {
        var values = new float[buffer.count * buffer.stride / sizeof(float)];
        buffer.GetData(values);
        return values;
    }
}
