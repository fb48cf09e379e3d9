#if UNITY_EDITOR
using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using UnityEditor;
using UnityEditor.SceneManagement;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// Plays a scene in the Unity Editor from the command line: opens --scene, enters play mode, plays --seconds at --fps
    /// without waiting for the clock, and leaves the Editor. Pictures are not taken: batch mode has no game view.
    /// </summary>
    internal static class EditorPlay
    {
        private const string PendingKey = "SphFluid.Validation.EditorPlay";

        public static void Enter(IReadOnlyList<string> commandLine)
        {
            string scene = Text(commandLine, "--scene", null);
            if (scene == null || !File.Exists(scene))
            {
                throw new CommandLineException($"--scene must be a .unity file of the project, found '{scene}'.");
            }
            EditorSceneManager.OpenScene(scene);
            // Entering play mode reloads the scripts; the session's state survives it.
            SessionState.SetBool(PendingKey, true);
            EditorApplication.EnterPlaymode();
        }

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.BeforeSceneLoad)]
        private static void OnPlayModeEntered()
        {
            if (!SessionState.GetBool(PendingKey, false)) return;
            SessionState.EraseBool(PendingKey);
            string[] commandLine = Environment.GetCommandLineArgs();
            float fps = Number(commandLine, "--fps", 24f);
            Time.captureDeltaTime = 1f / fps;
            CommandLine.Prepare(PlayArguments.Parse(commandLine));
            int frames = Mathf.Max(1, Mathf.RoundToInt(Number(commandLine, "--seconds", 2f) * fps)) + 1;
            EditorApplication.update += LeaveAfter(frames);
        }

        private static EditorApplication.CallbackFunction LeaveAfter(int frames)
        {
            EditorApplication.playModeStateChanged += change =>
            {
                if (change == PlayModeStateChange.EnteredEditMode) EditorApplication.Exit(0);
            };
            return () =>
            {
                if (EditorApplication.isPlaying && Time.frameCount >= frames) EditorApplication.ExitPlaymode();
            };
        }

        private static float Number(IReadOnlyList<string> commandLine, string flag, float absent)
        {
            string text = Text(commandLine, flag, null);
            if (text == null) return absent;
            if (float.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out float value) && value > 0f) return value;
            throw new CommandLineException($"{flag} must be a number above zero, found '{text}'.");
        }

        private static string Text(IReadOnlyList<string> commandLine, string flag, string absent)
        {
            for (int i = 0; i + 1 < commandLine.Count; i++)
            {
                if (commandLine[i] == flag) return commandLine[i + 1];
            }
            return absent;
        }
    }
}
#endif
