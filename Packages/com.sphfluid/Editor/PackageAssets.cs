using UnityEditor;
using UnityEngine;

namespace SphFluid.Editor
{
    /// <summary>Assets that the package brings.</summary>
    internal static class PackageAssets
    {
        public const string Folder = "Packages/com.sphfluid/Runtime/Assets/";

        /// <summary>The water profile; null when the package is not installed under its name.</summary>
        public static FluidProfile Water => Load<FluidProfile>("WaterProfile.asset");

        /// <summary>The shader set with the package's own shaders; null when the package is not installed under its name.</summary>
        public static FluidShaderSet Shaders => Load<FluidShaderSet>("DefaultFluidShaderSet.asset");

        /// <summary>Material of a tank's panes; null when the package is not installed under its name.</summary>
        public static Material TankGlass => Load<Material>("TankGlass.mat");

        /// <summary>Material of a tank's bars; null when the package is not installed under its name.</summary>
        public static Material TankFrame => Load<Material>("TankFrame.mat");

        private static T Load<T>(string file) where T : Object => AssetDatabase.LoadAssetAtPath<T>(Folder + file);
    }
}
