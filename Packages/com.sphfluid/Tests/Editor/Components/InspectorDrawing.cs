using System;
using NUnit.Framework;
using UnityEngine;
using Object = UnityEngine.Object;

namespace SphFluid.Tests
{
    /// <summary>Draws inspectors as a window does: once to lay out, once to paint.</summary>
    internal static class InspectorDrawing
    {
        /// <summary>Ignores the test where the Editor lets nothing be drawn outside a window.</summary>
        public static void Draw(params Object[] targets)
        {
            Event before = Event.current;
            UnityEditor.Editor editor = UnityEditor.Editor.CreateEditor(targets);
            try
            {
                foreach (EventType type in new[] { EventType.Layout, EventType.Repaint })
                {
                    Event.current = new Event { type = type };
                    editor.OnInspectorGUI();
                }
                editor.RequiresConstantRepaint();
            }
            catch (ArgumentException exception) when (exception.Message.Contains("inside OnGUI"))
            {
                Assert.Ignore(exception.Message);
            }
            finally
            {
                Event.current = before;
                Object.DestroyImmediate(editor);
            }
        }
    }
}
