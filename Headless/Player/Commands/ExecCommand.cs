using Headless.Engine;
using Headless.Player.Output;
using Headless.Player.Scripts;

namespace Headless.Player.Commands;

/// <summary>Calls a static method of the project in play mode with an empty scene; coroutines and objects it leaves behind run until it quits.</summary>
internal static class ExecCommand
{
    public static int Run(ExecOptions options)
    {
        var console = new ConsoleLines();
        EngineHooks.CompilerMissing = console.EndWithoutCompiler;
        using var interruption = new Interruption
        {
            Heard = () => Console.Error.WriteLine("\n" + Message.Of("stopping; what is finished is in the files. Ctrl-C again ends at once.")),
            EndFiles = () => Console.Error.WriteLine(Message.Of("interrupted; what was finished before is in the files.")),
        };
        using EngineSession session = EngineSession.Start(
            options.Project, options.Assemblies, options.Device, options.Validate, console.Write, options.Pipeline);
        if (session.PipelineNotice is { } notice) console.Write(UnityEngine.LogType.Log, notice);
        PlaySession.Begin(null, session.Assemblies);
        int code = MethodRunner.Run(session.Scripts.FindMethod("--executeMethod", options.ExecuteMethod)) ?? RunLoop(interruption);
        interruption.Acknowledge();
        interruption.EndHere();
        PlaySession.End();
        bool valid = EngineSession.ReportValidation();
        if (code != 0) return code;
        if (interruption.Requested) return Interruption.ExitCode;
        return valid && console.Errors == 0 ? 0 : 1;
    }

    /// <summary>Frames go on while the method left anything that could still work; without objects there is nothing to wait for.</summary>
    private static int RunLoop(Interruption interruption)
    {
        while (!interruption.Requested && !EngineState.QuitRequested && SceneTable.Scenes.Exists(s => s.Roots.Count > 0)) PlayerLoop.RunFrame();
        return EngineState.ExitCode;
    }
}
