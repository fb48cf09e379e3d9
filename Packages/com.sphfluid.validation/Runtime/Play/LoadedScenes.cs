using System.Collections.Generic;
using System.Linq;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace SphFluid.Validation
{
    /// <summary>What the loaded scenes hold.</summary>
    internal static class LoadedScenes
    {
        /// <summary>Their components of a kind, in the order of the hierarchy.</summary>
        /// <typeparam name="T">The kind.</typeparam>
        /// <param name="includeInactive">Whether those of inactive objects count.</param>
        public static IEnumerable<T> Find<T>(bool includeInactive = false) where T : Component =>
            Enumerable.Range(0, SceneManager.sceneCount).Select(SceneManager.GetSceneAt).Where(s => s.isLoaded)
                .SelectMany(s => s.GetRootGameObjects()).SelectMany(r => r.GetComponentsInChildren<T>(includeInactive));
    }
}
