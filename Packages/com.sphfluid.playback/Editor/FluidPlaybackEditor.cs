using System.IO;
using UnityEditor;
using UnityEngine;

namespace SphFluid.Editor
{
    /// <summary>Inspector of a playback: a button to choose the folder, what is wrong with it, and in play mode where it stands.</summary>
    [CustomEditor(typeof(FluidPlayback)), CanEditMultipleObjects]
    public sealed class FluidPlaybackEditor : UnityEditor.Editor
    {
        private FluidPlayback Shown => (FluidPlayback)target;

        /// <inheritdoc/>
        public override bool RequiresConstantRepaint() => Application.isPlaying && !serializedObject.isEditingMultipleObjects &&
            Shown.isActiveAndEnabled;

        /// <inheritdoc/>
        public override void OnInspectorGUI()
        {
            serializedObject.Update();
            DrawPropertiesExcluding(serializedObject, "m_Script");
            if (GUILayout.Button("Choose Folder…")) Choose(serializedObject.FindProperty("folder"));
            serializedObject.ApplyModifiedProperties();
            if (serializedObject.isEditingMultipleObjects)
            {
                EditorGUILayout.HelpBox("Select one playback to see what it plays.", MessageType.None);
                return;
            }
            if (!Application.isPlaying) _ = ((IFluidPlaybackSource)Shown).Playback; // looks at the folder
            if (Shown.Problem is FluidMessage problem) EditorGUILayout.HelpBox($"{problem.Text} {problem.Cure}", MessageType.Error);
            if (Application.isPlaying && Shown.IsOpen) DrawState();
        }

        /// <summary>A folder as the field has it: from StreamingAssets where it is in there.</summary>
        /// <param name="chosen">Absolute path.</param>
        /// <param name="streamingAssets">That of StreamingAssets.</param>
        internal static string Shortened(string chosen, string streamingAssets)
        {
            string full = Path.GetFullPath(chosen), root = Path.GetFullPath(streamingAssets).TrimEnd(Path.DirectorySeparatorChar) +
                Path.DirectorySeparatorChar;
            return (full.StartsWith(root, System.StringComparison.Ordinal) ? full.Substring(root.Length)
                : full).Replace(Path.DirectorySeparatorChar, '/');
        }

        private static void Choose(SerializedProperty folder)
        {
            string chosen = EditorUtility.OpenFolderPanel("Folder of a sequence", SequenceFolder.FullPath(folder.stringValue), "");
            if (!string.IsNullOrEmpty(chosen)) folder.stringValue = Shortened(chosen, Application.streamingAssetsPath);
        }

        private void DrawState()
        {
            FluidPlayback playback = Shown;
            EditorGUILayout.Space();
            EditorGUI.BeginChangeCheck();
            float time = EditorGUILayout.Slider("Go to", playback.Time, 0f, playback.Duration);
            if (EditorGUI.EndChangeCheck()) playback.Seek(time);
            EditorGUILayout.LabelField("Frame",
                $"{playback.CurrentFrame} of {playback.FrameCount}{(playback.IsBuffering ? ", reading" : "")}");
            if (playback.Source.Length > 0) EditorGUILayout.LabelField("Made by", playback.Source);
            EditorGUILayout.LabelField("Memory", $"{playback.MemoryBytes / 1048576.0:0.0} MiB");
            if (playback.LeftOutParticles > 0) EditorGUILayout.LabelField("Left out", $"{playback.LeftOutParticles} particles");
            if (playback.IsClockTaken) EditorGUILayout.LabelField("Time is set by", "a clip of a Timeline");
            if (playback.Clock != FluidPlaybackClock.SceneTime) return;
            if (GUILayout.Button(playback.IsPlaying ? "Pause" : "Play"))
            {
                if (playback.IsPlaying) playback.Pause();
                else playback.Play();
            }
        }
    }
}
