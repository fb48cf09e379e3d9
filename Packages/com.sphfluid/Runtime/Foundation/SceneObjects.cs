using System;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace SphFluid
{
    /// <summary>Searches the scenes that a component lives in: the loaded ones, or a prefab's own while it is edited by itself.</summary>
    internal static class SceneObjects
    {
        // Holds objects that outlive their scene; the scene manager does not list it.
        private const string LastingScene = "DontDestroyOnLoad";

        /// <summary>Whether a component belongs to a prefab asset: no scene, no physics and no other objects around it.</summary>
        public static bool IsPrefabAsset(Component component) => !component.gameObject.scene.IsValid();

        /// <summary>
        /// Components on active objects of the scenes that <paramref name="near"/> lives in. Unity's own search leaves out the scene in
        /// which a prefab is edited; of a prefab asset, the components of the whole prefab are returned; of null, those of the loaded
        /// scenes.
        /// </summary>
        public static T[] Find<T>(Component near) where T : Component
        {
            if (near == null) return All<T>();
            if (IsPrefabAsset(near)) return near.transform.root.GetComponentsInChildren<T>(true);
            Scene scene = near.gameObject.scene;
            return IsLoaded(scene) ? All<T>() : FindIn<T>(scene);
        }

        /// <summary>
        /// Components of the loaded scenes in no order: sort them by <see cref="HierarchyOrder"/> where the order matters.
        /// </summary>
        public static T[] All<T>(FindObjectsInactive inactive = FindObjectsInactive.Exclude) where T : Component =>
#if UNITY_6000_4_OR_NEWER
            UnityEngine.Object.FindObjectsByType<T>(inactive);
#else
            UnityEngine.Object.FindObjectsByType<T>(inactive, FindObjectsSortMode.None);
#endif

        private static bool IsLoaded(Scene scene)
        {
            for (int i = 0; i < SceneManager.sceneCount; i++)
                if (SceneManager.GetSceneAt(i) == scene) return true;
            return Application.isPlaying && scene.name == LastingScene;
        }

        private static T[] FindIn<T>(Scene scene) where T : Component
        {
            T[] found = Array.Empty<T>();
            foreach (GameObject root in scene.GetRootGameObjects())
            {
                T[] below = root.GetComponentsInChildren<T>();
                int before = found.Length;
                Array.Resize(ref found, before + below.Length);
                below.CopyTo(found, before);
            }
            return found;
        }
    }
}
