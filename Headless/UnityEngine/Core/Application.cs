using System;
using System.IO;
using System.Threading;
using Headless.Engine;
using UnityEngine.Events;

namespace UnityEngine;

public partial class Application
{
    public delegate void LogCallback(string condition, string stackTrace, LogType type);

    public delegate void LowMemoryCallback();

    static CancellationTokenSource s_Exit = new();

    public static event LogCallback? logMessageReceived;
    public static event LogCallback? logMessageReceivedThreaded;
    public static event Action? quitting;
    public static event Func<bool>? wantsToQuit;
    public static event Action<bool>? focusChanged;
    public static event UnityAction? onBeforeRender;
    public static event LowMemoryCallback? lowMemory { add { } remove { } }

    public static bool isPlaying => EngineState.IsPlaying;
    public static bool isEditor => EngineState.IsEditor;
    public static bool isBatchMode => EngineState.IsBatchMode;
    public static bool isFocused => true;
    public static bool isMobilePlatform => false;
    public static bool isConsolePlatform => false;
    public static bool runInBackground { get; set; } = true;
    public static int targetFrameRate { get; set; } = -1;
    public static string unityVersion => "2022.3.62f1";
    public static string version => "1.0";
    public static string productName => EngineState.ProductName;
    public static string companyName => EngineState.CompanyName;
    public static string identifier => $"com.{EngineState.CompanyName}.{EngineState.ProductName}";
    public static string dataPath => Path.Combine(EngineState.ProjectPath, "Assets");
    public static string streamingAssetsPath => Path.Combine(dataPath, "StreamingAssets");
    public static string temporaryCachePath => Directory.CreateDirectory(Path.Combine(Path.GetTempPath(), EngineState.CompanyName, EngineState.ProductName)).FullName;
    public static CancellationToken exitCancellationToken => s_Exit.Token;

    public static string persistentDataPath => Directory.CreateDirectory(Path.Combine(
        Environment.GetFolderPath(Environment.SpecialFolder.ApplicationData, Environment.SpecialFolderOption.DoNotVerify),
        "unity3d", EngineState.CompanyName, EngineState.ProductName)).FullName;

    public static RuntimePlatform platform
    {
        get
        {
            if (OperatingSystem.IsWindows()) return isEditor ? RuntimePlatform.WindowsEditor : RuntimePlatform.WindowsPlayer;
            if (OperatingSystem.IsMacOS()) return isEditor ? RuntimePlatform.OSXEditor : RuntimePlatform.OSXPlayer;
            return isEditor ? RuntimePlatform.LinuxEditor : RuntimePlatform.LinuxPlayer;
        }
    }

    public static bool IsPlaying(Object obj) => isPlaying && obj && !obj.IsPersistent;

    public static void Quit() => Quit(0);

    /// <summary>Ends the run after this frame; ignored in the Editor, as documented.</summary>
    public static void Quit(int exitCode)
    {
        if (isEditor) return;
        foreach (Func<bool> ask in wantsToQuit?.GetInvocationList() ?? Array.Empty<Delegate>())
            if (!ask()) return;
        EngineState.QuitRequested = true;
        EngineState.ExitCode = exitCode;
    }

    public static void SetStackTraceLogType(LogType logType, StackTraceLogType stackTraceType) { }

    internal static void SendLog(string condition, string stackTrace, LogType type)
    {
        logMessageReceived?.Invoke(condition, stackTrace, type);
        logMessageReceivedThreaded?.Invoke(condition, stackTrace, type);
    }

    internal static void SendBeforeRender() => onBeforeRender?.Invoke();
    internal static void SendFocus(bool focus) => focusChanged?.Invoke(focus);

    /// <summary>The run is going to end: what looks at <see cref="exitCancellationToken"/> ends sooner.</summary>
    internal static void RequestExit() => s_Exit.Cancel();

    internal static void SendQuitting()
    {
        foreach (Action handler in quitting?.GetInvocationList() ?? Array.Empty<Delegate>())
        {
            try
            {
                handler();
            }
            catch (Exception exception)
            {
                Debug.LogException(exception);
            }
        }
        s_Exit.Cancel();
        s_Exit = new CancellationTokenSource();
    }
}
