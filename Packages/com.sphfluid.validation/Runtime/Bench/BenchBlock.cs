using System.Collections.Generic;

namespace SphFluid.Validation
{
    /// <summary>A part of a frame that is measured: the profiler markers whose GPU times make it up.</summary>
    public sealed class BenchBlock
    {
        /// <summary>A part of some markers.</summary>
        /// <param name="name">Its name in tables.</param>
        /// <param name="markers">Names of the markers; none stands for one of the part's own name.</param>
        public BenchBlock(string name, params string[] markers)
        {
            Name = name;
            Markers = markers.Length > 0 ? markers : new[] { name };
        }

        /// <summary>Its name in tables.</summary>
        public string Name { get; }

        /// <summary>Names of the markers.</summary>
        public IReadOnlyList<string> Markers { get; }
    }
}
