namespace SphFluid
{
    /// <summary>What the GPU counted while it stepped, as of the last finished read-back (a few frames old).</summary>
    public struct FluidCounters
    {
        /// <summary>Times the emergency acceleration limit cut a particle's acceleration, since the start.</summary>
        public long AccelerationLimitHits;

        /// <summary>Times a particle was put back onto a face of the domain box, since the start.</summary>
        public long DomainClamps;

        /// <summary>
        /// Times a particle's position or velocity was not a finite number, since the start; it was stopped where it had been.
        /// </summary>
        public long NonFinite;

        /// <summary>Times a step hit a triangle and was changed, since the start.</summary>
        public long Contacts;

        /// <summary>
        /// Times a particle was as good as stopped because no path past the triangles was found, since the start. A few in narrow corners
        /// are normal.
        /// </summary>
        public long ContactFallbacks;

        /// <summary>
        /// Times a particle had no free place left, between colliders that close or a collider and a wall, since the start; it may now be
        /// on the wrong side.
        /// </summary>
        public long Squeezed;

        /// <summary>Times a step began on a triangle, since the start: a collider appeared or jumped onto the particle.</summary>
        public long Overlaps;

        /// <summary>Times a step was longer than contact follows and was shortened, since the start.</summary>
        public long ShortenedSteps;

        /// <summary>Particles that left the liquid since the start: through an open face, by a drain, or recycled.</summary>
        public long Removed;

        /// <summary>Particles that were born since the start.</summary>
        public long Born;

        /// <summary>Particles that were not born since the start because liquid, or a face of the domain, was in their place.</summary>
        public long Blocked;

        /// <summary>Particles that were not born since the start because the liquid had as many as it may have.</summary>
        public long Refused;

        /// <summary>
        /// Times a particle gave a body more than 32 times its mass by the speed of sound in a step, since the start; the body got no more
        /// than that.
        /// </summary>
        public long ImpulseLimits;

        /// <summary>Largest speed in the last recorded steps [m/s].</summary>
        public float MaxSpeed;

        /// <summary>Largest density in the last recorded steps over the rest density, minus one; 0.04 is 4 % compression.</summary>
        public float MaxCompression;
    }
}
