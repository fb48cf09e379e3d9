using UnityEditor;
using UnityEngine;

namespace SphFluid.Editor
{
    /// <summary>Assets that the package brings.</summary>
    internal static class PackageAssets
    {
        public const string Folder = "Packages/com.sphfluid/Runtime/Assets/";

        private const string Pictures = "Packages/com.sphfluid/Editor/Liquids/";

        /// <summary>One of the package's liquids; null when there is none of that name.</summary>
        public static FluidLiquid Liquid(string name) => Load<FluidLiquid>($"Liquids/{name}.asset");

        /// <summary>A tank with one of the package's liquids; null when there is none of that name.</summary>
        public static GameObject Prefab(string liquid) => Load<GameObject>($"Liquids/Prefabs/{liquid}.prefab");

        /// <summary>Picture of a liquid by its name; null for those that have none.</summary>
        public static Texture2D Picture(FluidLiquid liquid) => AssetDatabase.LoadAssetAtPath<Texture2D>($"{Pictures}{liquid.name}.png");

        /// <summary>The shader set with the package's own shaders; null when the package is not installed under its name.</summary>
        public static FluidShaderSet Shaders => Load<FluidShaderSet>("DefaultFluidShaderSet.asset");

        /// <summary>Material of a tank's panes; null when the package is not installed under its name.</summary>
        public static Material TankGlass => Load<Material>("TankGlass.mat");

        /// <summary>Material of a tank's bars; null when the package is not installed under its name.</summary>
        public static Material TankFrame => Load<Material>("TankFrame.mat");

        private static T Load<T>(string file) where T : Object => AssetDatabase.LoadAssetAtPath<T>(Folder + file);
    }
}
