namespace SphFluid.Validation
{
    /// <summary>A pair of particles that a neighbour search gets wrong, as particle i finds it.</summary>
    public readonly struct NeighbourAuditError
    {
        /// <summary>An error.</summary>
        /// <param name="particle">Id of the particle that searches.</param>
        /// <param name="other">Id of the one that it finds or does not.</param>
        /// <param name="distance">Between them, to the nearest image [m].</param>
        public NeighbourAuditError(uint particle, uint other, double distance)
        {
            Particle = particle;
            Other = other;
            Distance = distance;
        }

        /// <summary>Id of the particle that searches.</summary>
        public uint Particle { get; }

        /// <summary>Id of the one that it finds or does not.</summary>
        public uint Other { get; }

        /// <summary>Distance between them, to the nearest image [m].</summary>
        public double Distance { get; }

        /// <inheritdoc/>
        public override string ToString() => System.FormattableString.Invariant($"{Particle} and {Other} at {Distance:G4} m");
    }
}
