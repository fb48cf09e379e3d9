using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>A component that acts on running liquids: what it is at a moment, and on which.</summary>
    internal interface IFluidPart<out TSpec>
    {
        /// <summary>What it is now.</summary>
        TSpec Spec { get; }

        /// <summary>The simulation that it names; null for none.</summary>
        Component Named { get; }
    }

    /// <summary>
    /// Enabled components of a kind in all loaded scenes, in the order of the hierarchy as of the last that came; asking makes no garbage.
    /// </summary>
    internal static class FluidParts<TSpec>
    {
        private static readonly List<IFluidPart<TSpec>> Parts = new List<IFluidPart<TSpec>>();
        [OutlivesPlay("of no parts it says nothing")] private static bool isSorted = true;

        /// <summary>The components.</summary>
        public static IReadOnlyList<IFluidPart<TSpec>> InOrder
        {
            get
            {
                if (!isSorted) Parts.Sort((a, b) => HierarchyOrder.Compare((Component)a, (Component)b));
                isSorted = true;
                return Parts;
            }
        }

        /// <summary>One was enabled.</summary>
        public static void Add(IFluidPart<TSpec> part)
        {
            Parts.Add(part);
            isSorted = Parts.Count == 1;
        }

        /// <summary>One was disabled.</summary>
        public static void Remove(IFluidPart<TSpec> part) => Parts.Remove(part);

        /// <summary>Forgets all.</summary>
        public static void Clear() => Parts.Clear();
    }
}
