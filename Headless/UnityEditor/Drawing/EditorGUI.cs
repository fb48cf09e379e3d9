using System;
using System.Collections.Generic;
using UnityEngine;

namespace UnityEditor;

/// <summary>No window, no input: controls draw nothing and change nothing.</summary>
public sealed class EditorGUI
{
    static readonly Stack<bool> s_Changes = new();
    static readonly Stack<bool> s_Enabled = new();

    public static int indentLevel { get; set; }
    public static bool showMixedValue { get; set; }

    public static void BeginChangeCheck()
    {
        s_Changes.Push(GUI.changed);
        GUI.changed = false;
    }

    public static bool EndChangeCheck()
    {
        bool changed = GUI.changed;
        GUI.changed |= s_Changes.Pop();
        return changed;
    }

    public static void BeginDisabledGroup(bool disabled)
    {
        s_Enabled.Push(GUI.enabled);
        GUI.enabled &= !disabled;
    }

    public static void EndDisabledGroup() => GUI.enabled = s_Enabled.Pop();

    public static bool PropertyField(Rect position, SerializedProperty property) => false;
    public static bool PropertyField(Rect position, SerializedProperty property, GUIContent label) => false;
    public static bool PropertyField(Rect position, SerializedProperty property, GUIContent label, bool includeChildren) => false;
    public static void LabelField(Rect position, string label) { }
    public static void LabelField(Rect position, GUIContent label) { }
    public static void HelpBox(Rect position, string message, MessageType type) { }

    public static int Popup(Rect position, int selectedIndex, string[] displayedOptions) => selectedIndex;
    public static Rect PrefixLabel(Rect totalPosition, GUIContent label) => totalPosition;

    public struct DisabledScope : IDisposable
    {
        bool m_Disposed;

        public DisabledScope(bool disabled)
        {
            m_Disposed = false;
            BeginDisabledGroup(disabled);
        }

        public void Dispose()
        {
            if (m_Disposed) return;
            m_Disposed = true;
            EndDisabledGroup();
        }
    }

    public class ChangeCheckScope : GUI.Scope
    {
        bool m_Closed;
        bool m_Changed;

        public ChangeCheckScope() => BeginChangeCheck();

        public bool changed
        {
            get
            {
                if (m_Closed) return m_Changed;
                m_Closed = true;
                return m_Changed = EndChangeCheck();
            }
        }

        protected override void CloseScope() => _ = changed;
    }

    public class PropertyScope : GUI.Scope
    {
        public PropertyScope(Rect totalPosition, GUIContent label, SerializedProperty property) => content = label;

        public GUIContent content { get; protected set; }

        protected override void CloseScope() { }
    }

    public class IndentLevelScope : GUI.Scope
    {
        readonly int m_Increment;

        public IndentLevelScope() : this(1) { }

        public IndentLevelScope(int increment)
        {
            m_Increment = increment;
            indentLevel += increment;
        }

        protected override void CloseScope() => indentLevel -= m_Increment;
    }
}
