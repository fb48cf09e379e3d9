using System;

namespace SphFluid
{
    /// <summary>A request in <see cref="FluidQueries"/>; the default value is none.</summary>
    public readonly struct FluidQuery : IEquatable<FluidQuery>
    {
        internal readonly uint Generation;
        private readonly int kind;

        internal FluidQuery(QueryKind kind, int index, uint generation)
        {
            this.kind = kind.Index;
            Index = index;
            Generation = generation;
        }

        internal QueryKind Kind => QueryKind.All[kind];

        /// <summary>
        /// Its place among the requests of its kind, of a point in <see cref="FluidQueries.Points"/>; later requests have it once this one
        /// is removed.
        /// </summary>
        public int Index { get; }

        /// <summary>Whether both are the same request.</summary>
        /// <param name="other">The other.</param>
        /// <returns>True when they are.</returns>
        public bool Equals(FluidQuery other) => kind == other.kind && Index == other.Index && Generation == other.Generation;

        /// <inheritdoc/>
        public override bool Equals(object other) => other is FluidQuery query && Equals(query);

        /// <inheritdoc/>
        public override int GetHashCode() => (int)Generation;
    }
}
