using System;
using System.Linq;
using System.Reflection;

namespace SphFluid.Validation
{
    /// <summary>The package's shaders for code that no scene has given any.</summary>
    internal static class SessionAssets
    {
        private const string ShaderSet = "Packages/com.sphfluid/Runtime/Assets/DefaultFluidShaderSet.asset";

        /// <summary>The package's own shader set, in the Editor and the headless player; null elsewhere.</summary>
        public static FluidShaderSet PackageShaders => Load<FluidShaderSet>(ShaderSet);

        /// <summary>The shader set of a simulation that is loaded; without one, in the Editor, the package's own.</summary>
        /// <exception cref="FluidDeviceException">There is none.</exception>
        public static FluidShaderSet FindShaders()
        {
            FluidShaderSet shaders = FluidSimulation.Active.Where(s => s.Profile != null).Select(s => s.Profile.Shaders)
                .FirstOrDefault(s => s != null) ??
                PackageShaders;
            if (shaders == null)
            {
                throw new FluidDeviceException("No shaders were found: in a built player load a scene with a fluid simulation before, " +
                    $"in the Editor look whether '{ShaderSet}' is there.");
            }
            return shaders;
        }

        /// <summary>The shader set that a session was given.</summary>
        /// <param name="shaders">The shader set, or null.</param>
        /// <param name="subject">Who has it, with the verb: e.g. "The chart has".</param>
        /// <exception cref="FluidDeviceException">There is none.</exception>
        public static FluidShaderSet Require(FluidShaderSet shaders, string subject) =>
            shaders != null ? shaders
                : throw new FluidDeviceException($"{subject} no shader set. Install the package under its name, com.sphfluid.");

        /// <summary>
        /// An asset of a package by its path, in the Editor and the headless player; null elsewhere, and where there is none.
        /// </summary>
        /// <param name="path">Path that starts with Packages/ and the package's name.</param>
        public static T Load<T>(string path) where T : UnityEngine.Object
        {
            // By reflection: this assembly is also part of built players, which have no UnityEditor.
            Type database = Type.GetType("UnityEditor.AssetDatabase, UnityEditor");
            MethodInfo load = database?.GetMethod("LoadAssetAtPath", new[] { typeof(string), typeof(Type) });
            return (T)load?.Invoke(null, new object[] { path, typeof(T) });
        }
    }
}
