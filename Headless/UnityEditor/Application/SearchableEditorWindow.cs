namespace UnityEditor;

/// <summary>See <see cref="EditorWindow"/>.</summary>
public class SearchableEditorWindow : EditorWindow
{
}
