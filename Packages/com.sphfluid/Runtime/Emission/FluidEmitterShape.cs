namespace SphFluid
{
    /// <summary>Outline of an emitter's nozzle, in the plane across its forward axis.</summary>
    public enum FluidEmitterShape
    {
        /// <summary>A disc (or ellipse) that touches the edges of Size.</summary>
        Disc,

        /// <summary>A rectangle of Size.</summary>
        Rectangle,

        /// <summary>A slit: as long as Size along the x axis, and one particle spacing high.</summary>
        Line,

        /// <summary>What is seen of a mesh from ahead: liquid leaves from its front, along the emitter's forward axis.</summary>
        Mesh,
    }

    /// <summary>What settles how much an emitter gives.</summary>
    public enum FluidEmitterFlow
    {
        /// <summary>The speed at the nozzle in m/s.</summary>
        Speed,

        /// <summary>The volume a second in m³/s; the speed is that over the nozzle's area.</summary>
        VolumeRate,
    }

    /// <summary>What happens when a liquid into which more is emitted has as many particles as it has slots.</summary>
    public enum FluidCapacityPolicy
    {
        /// <summary>Twice as many slots are made, up to Max Particles of the profile.</summary>
        Grow,

        /// <summary>As many slots as Capacity are made at the start; what exceeds them is not emitted.</summary>
        Fixed,

        /// <summary>The oldest particles leave, so that no more than Capacity live.</summary>
        RecycleOldest,
    }
}
