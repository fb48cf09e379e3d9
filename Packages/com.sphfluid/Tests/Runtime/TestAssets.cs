using System;
using System.Linq;
using System.Reflection;
using NUnit.Framework;
using UnityEngine;
using Object = UnityEngine.Object;

namespace SphFluid.Tests
{
    /// <summary>The package's assets in play mode. The Editor finds them by path; a test player has no such means and skips.</summary>
    public static class TestAssets
    {
        /// <summary>The shipped water profile; the running test is ignored where it cannot be loaded.</summary>
        public static FluidProfile Water => Load<FluidProfile>("Packages/com.sphfluid/Runtime/Assets/WaterProfile.asset");

        // By reflection: a runtime test assembly does not refer to UnityEditor.
        static T Load<T>(string path) where T : Object
        {
            MethodInfo load = AppDomain.CurrentDomain.GetAssemblies()
                .Select(assembly => assembly.GetType("UnityEditor.AssetDatabase"))
                .FirstOrDefault(type => type != null)?
                .GetMethod("LoadAssetAtPath", new[] { typeof(string), typeof(Type) });
            if (load == null) Assert.Ignore("Assets are found by path in the Editor only.");
            var asset = (T)load.Invoke(null, new object[] { path, typeof(T) });
            Assert.That(asset, Is.Not.Null, path);
            return asset;
        }
    }
}
