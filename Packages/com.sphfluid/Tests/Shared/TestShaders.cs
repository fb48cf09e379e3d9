using System.Linq;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>The package's shaders.</summary>
    public static class TestShaders
    {
        private const string Package = "Packages/com.sphfluid/";

        /// <summary>The package's own shader set.</summary>
        public static FluidShaderSet PackageSet => TestAssets.Load<FluidShaderSet>(Package + "Runtime/Assets/DefaultFluidShaderSet.asset");

        /// <summary>A set of a test's own with the package's shaders; destroy it after use.</summary>
        public static FluidShaderSet CreateSet()
        {
            GpuTest.Require();
            var set = ScriptableObject.CreateInstance<FluidShaderSet>();
            FluidShaderSet package = PackageSet;
            set.ComputeShaders = package.ComputeShaders;
            set.Shaders = package.Shaders;
            return set;
        }

        /// <summary>A set like another, without the shader of a name; destroy it after use.</summary>
        public static FluidShaderSet Without(FluidShaderSet set, string name)
        {
            FluidShaderSet incomplete = Object.Instantiate(set);
            incomplete.ComputeShaders = set.ComputeShaders.Where(s => s.name != name).ToArray();
            incomplete.Shaders = set.Shaders.Where(s => s.name != name).ToArray();
            return incomplete;
        }

        /// <summary>A compute shader of the package.</summary>
        public static ComputeShader Load(string path)
        {
            GpuTest.Require();
            return TestAssets.Load<ComputeShader>(Package + path);
        }
    }
}
