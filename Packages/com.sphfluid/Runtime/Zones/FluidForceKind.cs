namespace SphFluid
{
    /// <summary>What a force zone does to the liquid in it.</summary>
    public enum FluidForceKind
    {
        /// <summary>Accelerates along the zone's forward axis.</summary>
        Directional,

        /// <summary>Accelerates towards the zone's centre, or with a strength below zero away from it.</summary>
        Point,

        /// <summary>Accelerates round the zone's y axis.</summary>
        Vortex,

        /// <summary>Drags towards a velocity along the zone's forward axis.</summary>
        Wind,

        /// <summary>Accelerates to and fro in eddies of a size that change with time.</summary>
        Turbulence,

        /// <summary>Drags towards rest.</summary>
        Damping,
    }

    /// <summary>Shape of a force zone.</summary>
    public enum FluidZoneShape
    {
        /// <summary>A box of Size.</summary>
        Box,

        /// <summary>A sphere of the diameter that is Size along x.</summary>
        Sphere,

        /// <summary>A capsule along y, of the diameter that is Size along x and the height that is Size along y.</summary>
        Capsule,

        /// <summary>The object's Box, Sphere or Capsule Collider.</summary>
        Collider,
    }
}
