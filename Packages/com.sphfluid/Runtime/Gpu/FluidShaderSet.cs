using System;
using System.Collections.Generic;
using UnityEngine;
using Object = UnityEngine.Object;

namespace SphFluid
{
    /// <summary>
    /// Every compute shader and shader of the package in one asset, found by name. A profile references it, so that components made
    /// from code, play mode and player builds find the shaders without a Resources folder.
    /// </summary>
    [CreateAssetMenu(menuName = "SPH Fluid/Fluid Shader Set", fileName = "FluidShaderSet", order = 201)]
    [ManualPage("index", "components-and-assets")]
    public sealed class FluidShaderSet : ScriptableObject
    {
        [SerializeField, Tooltip("The compute shaders of the package, in any order: each is found by its file's name.")]
        private ComputeShader[] computeShaders = Array.Empty<ComputeShader>();

        [SerializeField, Tooltip("The shaders that draw, in any order: each is found by the name that it declares.")]
        private Shader[] shaders = Array.Empty<Shader>();

        /// <summary>The compute shaders, in any order; found by their files' names.</summary>
        public IReadOnlyList<ComputeShader> ComputeShaders { get => computeShaders; set => computeShaders = Copy(value); }

        /// <summary>The shaders that draw, in any order; found by the names that they declare.</summary>
        public IReadOnlyList<Shader> Shaders { get => shaders; set => shaders = Copy(value); }

        /// <summary>A kernel of a compute shader.</summary>
        /// <param name="shader">Name of the compute shader's file without its ending.</param>
        /// <param name="kernel">Name of the kernel.</param>
        /// <returns>The kernel.</returns>
        /// <exception cref="FluidDeviceException">The shader is missing, has no such kernel, or the device cannot run it.</exception>
        public ComputeKernel Kernel(string shader, string kernel)
        {
            ComputeShader found = Find(computeShaders, shader);
            if (found == null)
            {
                throw new FluidDeviceException(
                    $"The shader set '{name}' has no compute shader '{shader}', which the kernel '{kernel}' is in. " +
                    "Add it to the set, or use the package's DefaultFluidShaderSet.");
            }

            return new ComputeKernel(found, kernel);
        }

        /// <summary>A shader that draws.</summary>
        /// <param name="name">The name that it declares.</param>
        /// <returns>The shader; null when the set has none of that name.</returns>
        public Shader Find(string name) => Find(shaders, name);

        /// <summary>Those of some shaders that the set has not.</summary>
        internal IReadOnlyList<string> Missing(IEnumerable<string> names)
        {
            var missing = new List<string>();
            foreach (string name in names)
            {
                if (Find(computeShaders, name) == null && Find(shaders, name) == null) missing.Add(name);
            }

            return missing;
        }

        private static T Find<T>(T[] all, string name) where T : Object
        {
            foreach (T one in all)
            {
                if (one != null && one.name == name) return one;
            }

            return null;
        }

        private static T[] Copy<T>(IReadOnlyList<T> list)
        {
            var copy = new T[list?.Count ?? 0];
            for (int i = 0; i < copy.Length; i++) copy[i] = list[i];
            return copy;
        }
    }
}
