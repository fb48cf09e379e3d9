using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using UnityEditor;
using UnityEngine;

namespace SphFluid.Validation.Editor
{
    /// <summary>
    /// Window > SPH Fluid > Choose a Method: which method, κ and spacing a flow needs on this machine, the same code as the command line's.
    /// </summary>
    public sealed class ChooseWindow : EditorWindow
    {
        private const string Path = "Window/SPH Fluid/Choose a Method";
        private const float PictureWidth = 600f, PictureHeight = 413f;

        private static readonly ValidationCase[] cases = ChooseArguments.Charted().ToArray();
        private static readonly string[] titles =
            cases.Select(c => c.Words.Count > 0 ? $"{string.Join(", ", c.Words)}: {c.Title}" : c.Title).ToArray();

        private readonly List<string> lines = new List<string>();
        private int chosen;
        private bool asksError = true, asksTime = true;
        private float error = 5f, milliseconds = 4f, framesPerSecond = 60f, length, volume, speed, compression = 4f;
        private Texture2D picture;

        /// <summary>Opens the window.</summary>
        [MenuItem(Path, false, 3012)]
        public static void Open() => GetWindow<ChooseWindow>("Choose a Method");

        /// <summary>What was answered last, line by line.</summary>
        internal IReadOnlyList<string> Lines => lines;

        private void OnGUI()
        {
            chosen = EditorGUILayout.Popup("Flow like", chosen, titles);
            using (new EditorGUILayout.HorizontalScope())
            {
                asksError = EditorGUILayout.Toggle("Error [%] at most", asksError);
                error = EditorGUILayout.FloatField("", error);
            }
            using (new EditorGUILayout.HorizontalScope())
            {
                asksTime = EditorGUILayout.Toggle("GPU ms a frame at most", asksTime);
                milliseconds = EditorGUILayout.FloatField("", milliseconds);
            }
            framesPerSecond = EditorGUILayout.FloatField("Frames a second", framesPerSecond);
            compression = EditorGUILayout.FloatField("Compression [%] at most", compression);
            EditorGUILayout.LabelField("The liquid; 0: as the case", EditorStyles.boldLabel);
            length = EditorGUILayout.FloatField($"Length [m]: {cases[chosen].LengthTitle}", length);
            volume = EditorGUILayout.FloatField("Volume [m³]", volume);
            speed = EditorGUILayout.FloatField("Fastest speed [m/s]", speed);
            if (GUILayout.Button("Choose")) Answer();
            if (lines.Count > 0) EditorGUILayout.HelpBox(string.Join("\n", lines), MessageType.None);
            if (picture != null) GUILayout.Label(picture, GUILayout.MaxWidth(PictureWidth), GUILayout.MaxHeight(PictureHeight));
        }

        private void OnDisable() => DestroyPicture();

        /// <summary>Answers what the fields ask.</summary>
        internal void Answer()
        {
            lines.Clear();
            DestroyPicture();
            try
            {
                ChooseArguments arguments = ChooseArguments.Parse(Words().ToArray());
                using (var session = new ChooseSession(arguments, null, new SessionProgress(lines.Add, null)))
                {
                    try
                    {
                        while (session.Step())
                        {
                        }
                    }
                    catch (IncompleteException)
                    {
                        // No answer: the lines say so, and the picture shows what is near.
                    }
                }
                ShowPicture(System.IO.Path.Combine(arguments.OutputFolder, "choose.png"));
            }
            catch (Exception exception) when (exception is CommandLineException || SessionDriver.IsExpected(exception))
            {
                lines.Add(exception.Message);
            }
        }

        // The command line's flags: one parser, one set of messages.
        private IEnumerable<string> Words()
        {
            var words = new List<string> { "--", "--case", cases[chosen].Name };
            void Add(string flag, float value, string unit = "")
            {
                words.Add(flag);
                words.Add(value.ToString(CultureInfo.InvariantCulture) + unit);
            }
            if (asksError) Add("--error", error, "%");
            if (asksTime) Add("--ms", milliseconds);
            Add("--fps", framesPerSecond);
            Add("--compression", compression, "%");
            if (length != 0f) Add("--length", length);
            if (volume != 0f) Add("--volume", volume);
            if (speed != 0f) Add("--speed", speed);
            return words;
        }

        private void ShowPicture(string file)
        {
            if (!File.Exists(file)) return; // without gnuplot
            picture = new Texture2D(2, 2) { hideFlags = HideFlags.HideAndDontSave };
            picture.LoadImage(File.ReadAllBytes(file));
        }

        private void DestroyPicture()
        {
            if (picture != null) DestroyImmediate(picture);
            picture = null;
        }
    }
}
