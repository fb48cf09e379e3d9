using System.Reflection;
using Headless.Engine;
using Headless.Files;
using Headless.Importers;
using Headless.Player.Scripts;
using Headless.Shaders;
using Headless.Vulkan;
using UnityEngine;

namespace Headless.Player;

/// <summary>The engine with a project open: device, shader compiler, script assemblies, assets.</summary>
internal sealed class EngineSession : IDisposable
{
    private EngineSession(UnityProject project, ScriptAssemblies scripts)
    {
        Project = project;
        Scripts = scripts;
    }

    public UnityProject Project { get; }
    public ScriptAssemblies Scripts { get; }
    public Assembly[] Assemblies { get; private init; } = [];

    /// <summary>What the user should know of the render pipeline that was asked for; null where nothing.</summary>
    public string? PipelineNotice { get; private init; }

    /// <param name="console">Takes the lines of the console.</param>
    /// <param name="pipeline">Name of the render pipeline; null for the project's.</param>
    /// <param name="direct3D">Compiles the kernels in the place of glslang.</param>
    public static EngineSession Start(
        string project, string? assemblies, string? device, bool validate, Action<LogType, string> console, string? pipeline = null,
        Direct3DFrontEnd? direct3D = null, MemoryChecks? checks = null)
    {
        EngineHooks.Console = console;
        var scripts = new ScriptAssemblies(assemblies);
        Assembly[] loaded = [.. scripts.LoadAll()];
        EngineState.ScriptAssemblies = loaded;
        var includes = new IncludeResolver(project);
        var compiler = new ShaderCompiler(Path.Combine(UserCache.Folder, "shaders"), includes) { Direct3D = direct3D };
        checks ??= MemoryChecks.FromEnvironment();
        GraphicsDevice.Initialize(
            new GpuDeviceOptions { Adapter = device, Validate = validate, Poison = checks.Poison, CheckBounds = checks.Bounds }, compiler);
        UnityProject opened = UnityProject.Open(project, scripts.Find, includes, line => console(LogType.Warning, "[Import] " + line));
        string? notice = PipelineChoice.Apply(pipeline);
        StaticMethods.Call<UnityEditor.InitializeOnLoadMethodAttribute>(_ => true);
        return new EngineSession(opened, scripts) { Assemblies = loaded, PipelineNotice = notice };
    }

    /// <summary>Statics are the same in each play of a process here, which only such settings ask for.</summary>
    public static void RequireStaticsThatStay(string flag)
    {
        if (EngineState.ReloadsDomain)
            throw new UsageException($"{flag} plays twice without a domain reload, and the project's settings ask for one: set Edit > Project Settings > Editor > When entering Play Mode to Reload Scene only.");
    }

    /// <summary>
    /// Prints the buffers that nobody released, what the validation layer found, and accesses outside buffers that were checked; true when
    /// there are none of the latter two.
    /// </summary>
    public static bool ReportValidation()
    {
        GraphicsDevice.FindLeaks();
        IReadOnlyList<string> messages = GraphicsDevice.Device.ValidationMessages;
        foreach (string message in messages.Distinct()) Console.Error.WriteLine("[Validation] " + message);
        if (messages.Count > 0) Console.Error.WriteLine(Message.Of($"the validation layers had {messages.Count} message(s)."));
        IReadOnlyList<string> outside = GraphicsDevice.Device.TakeOutOfBounds();
        foreach (string line in outside) Console.Error.WriteLine("[Bounds] " + line);
        return messages.Count == 0 && outside.Count == 0;
    }

    public void Dispose()
    {
        PlaySession.End();
        StereoChoice.Apply(null);
        PipelineChoice.Apply(PipelineChoice.BuiltIn);
        EngineState.Reset();
        GraphicsDevice.Shutdown();
    }
}
