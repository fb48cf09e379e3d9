namespace SphFluid
{
    /// <summary>Tells once of liquid that went farther than an open domain reaches.</summary>
    internal sealed class FarthestWatch
    {
        private bool said;

        /// <summary>Takes note of a frame.</summary>
        /// <param name="spec">The simulation.</param>
        /// <param name="left">Particles that left through faces of the domain, as of a few frames ago.</param>
        /// <returns>What to report; null when nothing new.</returns>
        public FluidMessage? Update(in FluidSpec spec, long left)
        {
            if (said || !spec.IsOpen || left == 0) return null;
            said = true;
            return new FluidMessage(FluidSeverity.Warning, FluidIssue.FarthestReached, spec.Owner,
                $"Liquid goes farther than Farthest Distance, {FluidMessage.Lengths(0.5f * spec.DomainSize)} m from this object, and " +
                "is removed there; Removed Particles counts it.",
                "Raise Farthest Distance, move the object to where the liquid goes, or end the flow earlier, with a Fluid Drain or an " +
                "emitter's Lifetime.");
        }
    }
}
