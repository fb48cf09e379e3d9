using System.Text.RegularExpressions;
using Headless.Engine;

namespace UnityEngine.TestTools;

/// <summary>Errors, assertions and exceptions in the log fail the running test unless they are expected.</summary>
public static class LogAssert
{
    public static bool ignoreFailingMessages
    {
        get => LogScope.Current.IgnoreFailingMessages;
        set => LogScope.Current.IgnoreFailingMessages = value;
    }

    public static void Expect(LogType type, string message) => LogScope.Current.Expect(new ExpectedLog(type, message, null));
    public static void Expect(LogType type, Regex message) => LogScope.Current.Expect(new ExpectedLog(type, null, message));
    public static void NoUnexpectedReceived() => LogScope.Current.RequireAllHandled();
}
