using System;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace SphFluid
{
    /// <summary>
    /// A name by which a component is found again in another session: the names of its object and of those above it, with a number where
    /// siblings share a name, and its type with its number among those of its kind on the object. Worked example:
    /// "Crates/Crate#2:BoxCollider".
    /// </summary>
    internal static class ScenePath
    {
        /// <summary>The path of a component of a loaded scene.</summary>
        public static string GetPath(Component component)
        {
            string path = "";
            for (Transform t = component.transform; t != null; t = t.parent)
            {
                path = $"{(t.parent == null ? "" : "/")}{t.name}{Numbered(NumberOf(t))}{path}";
            }
            return $"{path}:{component.GetType().Name}{Numbered(Array.IndexOf(component.GetComponents(component.GetType()), component))}";
        }

        private static string Numbered(int number) => number > 0 ? $"#{number}" : "";

        // Among siblings of its name.
        private static int NumberOf(Transform transform)
        {
            int number = 0;
            if (transform.parent != null)
            {
                for (int i = 0; i < transform.GetSiblingIndex(); i++) number += transform.parent.GetChild(i).name == transform.name ? 1 : 0;
                return number;
            }
            Scene scene = transform.gameObject.scene;
            if (!scene.IsValid()) return 0;
            foreach (GameObject root in scene.GetRootGameObjects())
            {
                if (ReferenceEquals(root.transform, transform)) break;
                number += root.name == transform.name ? 1 : 0;
            }
            return number;
        }
    }
}
