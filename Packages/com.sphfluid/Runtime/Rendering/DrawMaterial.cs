using UnityEngine;
using Object = UnityEngine.Object;

namespace SphFluid
{
    /// <summary>A material that code made from a shader of the shader set, and its end.</summary>
    static class DrawMaterial
    {
        /// <exception cref="FluidDeviceException">The shader is missing, or the device cannot run it.</exception>
        public static Material Create(Shader shader, string field)
        {
            if (shader == null)
                throw new FluidDeviceException($"The shader set has no '{field}'. Assign it in the fluid shader set.");
            if (!shader.isSupported)
                throw new FluidDeviceException($"{SystemInfo.graphicsDeviceName} ({SystemInfo.graphicsDeviceType}) cannot run the shader '{shader.name}'.");
            return new Material(shader) { name = shader.name, hideFlags = HideFlags.HideAndDontSave };
        }

        public static void SetKeyword(Material made, string keyword, bool on)
        {
            if (on)
                made.EnableKeyword(keyword);
            else
                made.DisableKeyword(keyword);
        }

        public static void Destroy<T>(ref T made) where T : Object
        {
            if (made != null)
            {
                if (Application.isPlaying)
                    Object.Destroy(made);
                else
                    Object.DestroyImmediate(made);
            }
            made = null;
        }
    }
}
