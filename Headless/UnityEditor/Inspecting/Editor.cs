using System;
using System.Reflection;
using Headless.Engine;
using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor;

public class Editor : ScriptableObject
{
    Object[] m_Targets = Array.Empty<Object>();
    SerializedObject? m_SerializedObject;

    public Object target { get => m_Targets.Length > 0 ? m_Targets[0] : null!; set => m_Targets = new[] { value }; }
    public Object[] targets => m_Targets;
    public SerializedObject serializedObject => m_SerializedObject ??= new SerializedObject(m_Targets);

    public virtual void OnInspectorGUI() => DrawDefaultInspector();
    public virtual bool RequiresConstantRepaint() => false;
    public virtual bool UseDefaultMargins() => true;
    public virtual bool HasPreviewGUI() => false;
    public virtual void OnPreviewGUI(Rect r, GUIStyle background) { }
    public virtual Texture2D RenderStaticPreview(string assetPath, Object[] subAssets, int width, int height) => null!;
    public void Repaint() { }

    public bool DrawDefaultInspector()
    {
        serializedObject.Update();
        DrawPropertiesExcluding(serializedObject);
        return serializedObject.ApplyModifiedProperties();
    }

    protected internal static void DrawPropertiesExcluding(SerializedObject obj, params string[] propertyToExclude)
    {
        SerializedProperty property = obj.GetIterator();
        for (bool enter = true; property.NextVisible(enter); enter = false)
            if (Array.IndexOf(propertyToExclude, property.name) < 0) EditorGUILayout.PropertyField(property, true);
    }

    public static Editor CreateEditor(Object targetObject) => CreateEditor(new[] { targetObject }, null);
    public static Editor CreateEditor(Object targetObject, Type? editorType) => CreateEditor(new[] { targetObject }, editorType);
    public static Editor CreateEditor(Object[] targetObjects) => CreateEditor(targetObjects, null);

    public static Editor CreateEditor(Object[] targetObjects, Type? editorType)
    {
        editorType ??= EditorTypeFor(targetObjects[0].GetType()) ?? typeof(Editor);
        var editor = (Editor)CreateRaw(editorType);
        editor.m_Targets = targetObjects;
        editor.SendAwake();
        return editor;
    }

    static Type? EditorTypeFor(Type inspected)
    {
        foreach (Assembly assembly in AppDomain.CurrentDomain.GetAssemblies())
        {
            if (assembly.IsDynamic) continue;
            foreach (Type type in TypeLookup.Types(assembly))
            {
                if (!typeof(Editor).IsAssignableFrom(type) || type.GetCustomAttribute<CustomEditor>(false) is not { } custom) continue;
                if (custom.InspectedType == inspected || (custom.ForChildClasses && custom.InspectedType.IsAssignableFrom(inspected))) return type;
            }
        }
        return null;
    }
}
