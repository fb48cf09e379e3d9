using System;
using System.Diagnostics;
using Headless.Engine;

namespace UnityEngine;

public partial class Debug
{
    static readonly ILogger s_Logger = new Logger(new ConsoleLogHandler());

    public static ILogger unityLogger => s_Logger;
    public static bool developerConsoleEnabled { get; set; }
    public static bool developerConsoleVisible { get; set; }
    public static bool isDebugBuild => true;

    public static void Log(object message) => s_Logger.Log(LogType.Log, message);
    public static void Log(object message, Object context) => s_Logger.Log(LogType.Log, message, context);
    public static void LogFormat(string format, params object[] args) => s_Logger.LogFormat(LogType.Log, format, args);
    public static void LogFormat(Object context, string format, params object[] args) => s_Logger.LogFormat(LogType.Log, context, format, args);
    public static void LogFormat(LogType logType, LogOption logOptions, Object context, string format, params object[] args) => s_Logger.LogFormat(logType, context, format, args);
    public static void LogWarning(object message) => s_Logger.Log(LogType.Warning, message);
    public static void LogWarning(object message, Object context) => s_Logger.Log(LogType.Warning, message, context);
    public static void LogWarningFormat(string format, params object[] args) => s_Logger.LogFormat(LogType.Warning, format, args);
    public static void LogWarningFormat(Object context, string format, params object[] args) => s_Logger.LogFormat(LogType.Warning, context, format, args);
    public static void LogError(object message) => s_Logger.Log(LogType.Error, message);
    public static void LogError(object message, Object context) => s_Logger.Log(LogType.Error, message, context);
    public static void LogErrorFormat(string format, params object[] args) => s_Logger.LogFormat(LogType.Error, format, args);
    public static void LogErrorFormat(Object context, string format, params object[] args) => s_Logger.LogFormat(LogType.Error, context, format, args);
    public static void LogException(Exception exception) => s_Logger.LogException(exception, null);
    public static void LogException(Exception exception, Object context) => s_Logger.LogException(exception, context);

    [Conditional("UNITY_ASSERTIONS")] public static void LogAssertion(object message) => s_Logger.Log(LogType.Assert, message);
    [Conditional("UNITY_ASSERTIONS")] public static void LogAssertion(object message, Object context) => s_Logger.Log(LogType.Assert, message, context);
    [Conditional("UNITY_ASSERTIONS")] public static void LogAssertionFormat(string format, params object[] args) => s_Logger.LogFormat(LogType.Assert, format, args);
    [Conditional("UNITY_ASSERTIONS")] public static void LogAssertionFormat(Object context, string format, params object[] args) => s_Logger.LogFormat(LogType.Assert, context, format, args);
    [Conditional("UNITY_ASSERTIONS")] public static void Assert(bool condition) { if (!condition) s_Logger.Log(LogType.Assert, "Assertion failed"); }
    [Conditional("UNITY_ASSERTIONS")] public static void Assert(bool condition, Object context) { if (!condition) s_Logger.Log(LogType.Assert, (object)"Assertion failed", context); }
    [Conditional("UNITY_ASSERTIONS")] public static void Assert(bool condition, object message) { if (!condition) s_Logger.Log(LogType.Assert, message); }
    [Conditional("UNITY_ASSERTIONS")] public static void Assert(bool condition, string message) { if (!condition) s_Logger.Log(LogType.Assert, message); }
    [Conditional("UNITY_ASSERTIONS")] public static void Assert(bool condition, object message, Object context) { if (!condition) s_Logger.Log(LogType.Assert, message, context); }
    [Conditional("UNITY_ASSERTIONS")] public static void Assert(bool condition, string message, Object context) { if (!condition) s_Logger.Log(LogType.Assert, (object)message, context); }
    [Conditional("UNITY_ASSERTIONS")] public static void AssertFormat(bool condition, string format, params object[] args) { if (!condition) s_Logger.LogFormat(LogType.Assert, format, args); }
    [Conditional("UNITY_ASSERTIONS")] public static void AssertFormat(bool condition, Object context, string format, params object[] args) { if (!condition) s_Logger.LogFormat(LogType.Assert, context, format, args); }

    public static void Break() { }
    public static void ClearDeveloperConsole() { }
}
