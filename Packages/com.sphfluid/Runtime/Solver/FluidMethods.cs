using System;
using System.Collections.Generic;

namespace SphFluid
{
    /// <summary>
    /// The list of methods: a new one is a value of <see cref="FluidMethodKind"/>, a line here and a folder of its own. One in an assembly
    /// of its own registers itself, before the first scene is loaded and whenever the Editor loads it.
    /// </summary>
    internal static class FluidMethods
    {
        private static readonly List<FluidMethod> Methods = new List<FluidMethod> { new StandardMethod(), new RobustMethod() };

        /// <summary>All methods, the default one first.</summary>
        public static IReadOnlyList<FluidMethod> All => Methods;

        /// <summary>Adds a method of another assembly; of one that is there already it takes the place.</summary>
        public static void Register(FluidMethod method)
        {
            Methods.RemoveAll(m => m.Kind == method.Kind);
            Methods.Add(method);
        }

        /// <summary>Whether the method is to be chosen at the start.</summary>
        public static bool IsChosen(FluidMethodKind kind) => kind == FluidMethodKind.Automatic;

        /// <summary>Whether there is such a method: a scene's number may be from another version of the package.</summary>
        public static bool Has(FluidMethodKind kind) => Find(kind) != null;

        /// <summary>Whether a method has a feature; one that is not there has none.</summary>
        public static bool Has(FluidMethodKind kind, FluidMethodFeatures feature) => Find(kind)?.Has(feature) ?? false;

        /// <summary>The shaders of all methods, each group once.</summary>
        public static IReadOnlyList<ShaderGroup> ShaderGroups => EachOnce(method => method.Shaders);

        /// <summary>Surfaces that methods bring along, each group once.</summary>
        public static IReadOnlyList<ShaderGroup> SurfaceGroups => EachOnce(method => method.OwnSurface);

        /// <summary>A method.</summary>
        /// <exception cref="ArgumentException">There is none of that number.</exception>
        public static FluidMethod Get(FluidMethodKind kind) => Find(kind) ??
            throw new ArgumentException($"There is no fluid method {kind}.", nameof(kind));

        private static List<ShaderGroup> EachOnce(Func<FluidMethod, ShaderGroup> groupOf)
        {
            var groups = new List<ShaderGroup>();
            foreach (FluidMethod method in Methods)
            {
                ShaderGroup group = groupOf(method);
                if (group != null && !groups.Contains(group)) groups.Add(group);
            }

            return groups;
        }

        private static FluidMethod Find(FluidMethodKind kind)
        {
            foreach (FluidMethod method in Methods)
            {
                if (method.Kind == kind) return method;
            }

            return null;
        }
    }
}
