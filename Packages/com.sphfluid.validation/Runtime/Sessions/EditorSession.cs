#if UNITY_EDITOR
using System;
using UnityEditor;

namespace SphFluid.Validation
{
    /// <summary>Runs a measurement in the Unity Editor from the command line, outside play mode, and leaves the Editor.</summary>
    internal static class EditorSession
    {
        public static void Begin(IValidationSession session)
        {
            EditorApplication.update += () =>
            {
                try
                {
                    if (session.Step()) return;
                    session.Dispose();
                    EditorApplication.Exit(0);
                }
                catch (Exception exception)
                {
                    Console.Error.WriteLine(SessionDriver.IsExpected(exception) ? exception.Message : exception.ToString());
                    session.Dispose();
                    EditorApplication.Exit(1);
                }
            };
        }
    }
}
#endif
