using System;
using System.Collections.Generic;

namespace SphFluid
{
    /// <summary>Methods to compute the liquid's motion.</summary>
    public enum FluidMethodKind
    {
        /// <summary>Figueroa's thesis (2012), corrected: Müller's kernels, bitonic sort, one time step after another.</summary>
        Thesis = 0,

        /// <summary>The thesis's text as printed, as far as it can run (<see cref="ThesisSwitches.Printed"/>): for comparison, not for use.</summary>
        ThesisPrinted = 1,

        /// <summary>Weakly compressible SPH with one kernel, walls that carry density, and a counting sort: faster, more accurate, the default.</summary>
        Standard = 2,

        /// <summary>Small-step XPBD: a fixed number of equal steps a frame at any speed. Never explodes, keeps real time, and is the softer the longer its steps are.</summary>
        Robust = 3,

        /// <summary>
        /// No method but a choice among them at the start: the most faithful one whose steps fit the frame budget of the simulation, by what they cost on this
        /// device. <see cref="FluidSimulation.ActiveMethod"/> is the one picked. A solver takes only a picked one.
        /// </summary>
        Automatic = 4,
    }

    /// <summary>The list of methods: a new one is a value above, a line here and a folder of its own.</summary>
    internal static class FluidMethods
    {
        static readonly FluidMethod[] Methods =
        {
            new StandardMethod(),
            new RobustMethod(),
            new ThesisMethod(FluidMethodKind.Thesis),
            new ThesisMethod(FluidMethodKind.ThesisPrinted),
        };

        /// <summary>All methods, the default one first.</summary>
        public static IReadOnlyList<FluidMethod> All => Methods;

        /// <summary>Whether the method is to be chosen at the start.</summary>
        public static bool IsChosen(FluidMethodKind kind) => kind == FluidMethodKind.Automatic;

        /// <summary>Whether there is such a method: a scene's number may be from another version of the package.</summary>
        public static bool Has(FluidMethodKind kind) => Find(kind) != null;

        /// <summary>Whether a method has a feature; one that is not there has none.</summary>
        public static bool Has(FluidMethodKind kind, FluidMethodFeatures feature) => Find(kind)?.Has(feature) ?? false;

        /// <summary>The shaders of all methods, each group once.</summary>
        public static IReadOnlyList<ShaderGroup> ShaderGroups
        {
            get
            {
                var groups = new List<ShaderGroup>();
                foreach (FluidMethod method in Methods)
                {
                    if (!groups.Contains(method.Shaders)) groups.Add(method.Shaders);
                }

                return groups;
            }
        }

        /// <summary>A method.</summary>
        /// <exception cref="ArgumentException">There is none of that number.</exception>
        public static FluidMethod Of(FluidMethodKind kind) => Find(kind) ?? throw new ArgumentException($"There is no fluid method {kind}.", nameof(kind));

        static FluidMethod Find(FluidMethodKind kind)
        {
            foreach (FluidMethod method in Methods)
            {
                if (method.Kind == kind) return method;
            }

            return null;
        }
    }
}
