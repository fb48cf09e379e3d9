using System;

namespace SphFluid.Validation
{
    /// <summary>How clear water of the benchmark is drawn.</summary>
    public readonly struct BenchWaterLook : IEquatable<BenchWaterLook>
    {
        /// <param name="quality">How closely light is followed.</param>
        /// <param name="drops">Drops of a particle without company; 0: it stays in the surface.</param>
        public BenchWaterLook(FluidWaterQuality quality, int drops)
        {
            Quality = quality;
            Drops = drops;
        }

        /// <summary>How closely light is followed.</summary>
        public FluidWaterQuality Quality { get; }

        /// <summary>Drops of a particle without company.</summary>
        public int Drops { get; }

        /// <summary>Name in tables, e.g. fine_spray.</summary>
        public string Name => Quality.ToString().ToLowerInvariant() + (Drops > 0 ? "_spray" : "");

        /// <summary>Name for people, e.g. fine, spray.</summary>
        public string Title => Name.Replace("_", ", ");

        /// <inheritdoc/>
        public bool Equals(BenchWaterLook other) => Quality == other.Quality && Drops == other.Drops;

        /// <inheritdoc/>
        public override bool Equals(object obj) => obj is BenchWaterLook other && Equals(other);

        /// <inheritdoc/>
        public override int GetHashCode() => (int)Quality * 397 ^ Drops;
    }
}
