using UnityEngine;

namespace SphFluid
{
    /// <summary>A material that code made from a shader of the shader set.</summary>
    internal static class DrawMaterial
    {
        /// <param name="shaders">The shader set.</param>
        /// <param name="name">Name that the shader declares.</param>
        /// <exception cref="FluidDeviceException">The shader is missing, or the device cannot run it.</exception>
        public static Material Create(FluidShaderSet shaders, string name)
        {
            Shader shader = shaders.Find(name);
            if (shader == null)
            {
                throw new FluidDeviceException(
                    $"The shader set '{shaders.name}' has no shader '{name}'. Add it to the set, or use the package's " +
                    "DefaultFluidShaderSet.");
            }
            return Create(shader);
        }

        /// <exception cref="FluidDeviceException">The device cannot run the shader.</exception>
        public static Material Create(Shader shader)
        {
            if (!shader.isSupported)
            {
                throw new FluidDeviceException(
                    $"{SystemInfo.graphicsDeviceName} ({SystemInfo.graphicsDeviceType}) cannot run the shader '{shader.name}'.");
            }
            return new Material(shader) { name = shader.name, hideFlags = HideFlags.HideAndDontSave };
        }

        public static void SetKeyword(Material made, string keyword, bool on)
        {
            if (on)
                made.EnableKeyword(keyword);
            else
                made.DisableKeyword(keyword);
        }
    }
}
