using System;
using System.Reflection;
using NUnit.Framework;
using UnityEngine;
using Object = UnityEngine.Object;

namespace SphFluid.Tests
{
    /// <summary>The project's assets by path, in edit and in play mode. A test player has no such means and skips.</summary>
    public static class TestAssets
    {
        /// <summary>The shipped water profile; the running test is ignored where it cannot be loaded.</summary>
        public static FluidProfile Water => Load<FluidProfile>("Packages/com.sphfluid/Runtime/Assets/WaterProfile.asset");

        /// <summary>An asset; the running test fails where there is none, and is ignored where assets are not found by path.</summary>
        public static T Load<T>(string path) where T : Object
        {
            // By reflection: an assembly that test players have does not refer to UnityEditor.
            MethodInfo load = Type.GetType("UnityEditor.AssetDatabase, UnityEditor")
                ?.GetMethod("LoadAssetAtPath", new[] { typeof(string), typeof(Type) });
            if (load == null) Assert.Ignore("Assets are found by path in the Editor only.");
            var asset = (T)load.Invoke(null, new object[] { path, typeof(T) });
            Assert.That(asset, Is.Not.Null, path);
            return asset;
        }
    }
}
