using System;
using System.Linq;
using System.Reflection;

namespace SphFluid.Tests
{
    /// <summary>What a game gets by the product: types of its assembly and of the thesis's.</summary>
    internal static class ProductTypes
    {
        /// <summary>The assemblies.</summary>
        public static Assembly[] Assemblies => new[] { typeof(FluidSimulation).Assembly, typeof(FluidGeometrySurfaceRenderer).Assembly };

        /// <summary>Their types.</summary>
        public static Type[] All => Assemblies.SelectMany(a => a.GetTypes()).ToArray();
    }
}
