using UnityEngine;

namespace SphFluid
{
    /// <summary>The end of an object that code made and alone uses: a material, a mesh, a texture.</summary>
    internal static class OwnedObject
    {
        /// <summary>Destroys it, at once outside play mode, and forgets it.</summary>
        /// <param name="made">The object; null afterwards.</param>
        public static void Destroy<T>(ref T made) where T : Object
        {
            if (made != null)
            {
                if (Application.isPlaying) Object.Destroy(made);
                else Object.DestroyImmediate(made);
            }

            made = null;
        }
    }
}
