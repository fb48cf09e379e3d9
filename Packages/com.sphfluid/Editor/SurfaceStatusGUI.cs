using UnityEditor;

namespace SphFluid.Editor
{
    /// <summary>What a surface is made of, for inspectors in play mode.</summary>
    internal static class SurfaceStatusGUI
    {
        private const double Mebibyte = 1024.0 * 1024.0;

        public static void Draw(in SurfaceStatus status, long gpuBytes)
        {
            EditorGUILayout.LabelField("Triangles", status.Triangles.ToString("N0"));
            EditorGUILayout.LabelField("Blocks", status.Blocks.ToString("N0"));
            EditorGUILayout.LabelField("GPU memory", $"{gpuBytes / Mebibyte:0.0} MiB");
        }
    }
}
