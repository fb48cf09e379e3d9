using System;

namespace SphFluid
{
    /// <summary>A request in <see cref="FluidQueries"/>; the default value is none.</summary>
    public readonly struct FluidQuery : IEquatable<FluidQuery>
    {
        internal readonly uint Generation;
        internal readonly QueryKind Kind;

        internal FluidQuery(QueryKind kind, int index, uint generation)
        {
            Kind = kind;
            Index = index;
            Generation = generation;
        }

        /// <summary>Its place among the requests of its kind, of a point in <see cref="FluidQueries.Points"/>; later requests have it once this one is removed.</summary>
        public int Index { get; }

        /// <summary>Whether both are the same request.</summary>
        /// <param name="other">The other.</param>
        /// <returns>True when they are.</returns>
        public bool Equals(FluidQuery other) => Kind == other.Kind && Index == other.Index && Generation == other.Generation;

        /// <inheritdoc/>
        public override bool Equals(object other) => other is FluidQuery query && Equals(query);

        /// <inheritdoc/>
        public override int GetHashCode() => (int)Generation;
    }
}
