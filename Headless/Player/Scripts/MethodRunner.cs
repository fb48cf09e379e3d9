using System.Reflection;
using Headless.Engine;

namespace Headless.Player.Scripts;

/// <summary>Calls a project's static method, as Unity's -executeMethod does.</summary>
internal static class MethodRunner
{
    private const int Failed = 1;

    /// <returns>Null to go on; an exit code when the method asked to quit (Application.Quit, EditorApplication.Exit) or threw.</returns>
    public static int? Run(MethodInfo method)
    {
        try
        {
            method.Invoke(null, BindingFlags.DoNotWrapExceptions, null, null, null);
        }
        catch (Exception e)
        {
            Console.Error.WriteLine(Message.Of($"{method.DeclaringType}.{method.Name} ended with an exception: {e}"));
            return Failed;
        }
        return EngineState.QuitRequested ? EngineState.ExitCode : null;
    }
}
