using UnityEditor;
using UnityEngine;

namespace SphFluid.Editor
{
    /// <summary>Inspector of liquids: the fields of its look, and its picture.</summary>
    [CustomEditor(typeof(FluidLiquid)), CanEditMultipleObjects]
    public sealed class FluidLiquidEditor : UnityEditor.Editor
    {
        /// <inheritdoc/>
        public override void OnInspectorGUI()
        {
            serializedObject.Update();
            FluidInspector.Draw(serializedObject, Hidden(serializedObject));
            serializedObject.ApplyModifiedProperties();
        }

        /// <inheritdoc/>
        public override bool HasPreviewGUI() => PackageAssets.Picture((FluidLiquid)target) != null;

        /// <inheritdoc/>
        public override void OnPreviewGUI(Rect place, GUIStyle background) =>
            GUI.DrawTexture(place, PackageAssets.Picture((FluidLiquid)target), ScaleMode.ScaleToFit);

        /// <inheritdoc/>
        public override Texture2D RenderStaticPreview(string assetPath, Object[] subAssets, int width, int height)
        {
            Texture2D picture = PackageAssets.Picture((FluidLiquid)target);
            if (picture == null) return null;
            var preview = new Texture2D(width, height);
            EditorUtility.CopySerialized(picture, preview);
            return preview;
        }

        private static string[] Hidden(SerializedObject edited)
        {
            SerializedProperty look = edited.FindProperty("look");
            return look.hasMultipleDifferentValues ? new string[0]
                : FluidSurfaceRendererEditor.Hidden((FluidSurfaceLook)look.enumValueIndex);
        }
    }
}
