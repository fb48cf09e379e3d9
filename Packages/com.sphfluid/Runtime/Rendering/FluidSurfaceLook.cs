namespace SphFluid
{
    /// <summary>How the surface of a liquid is drawn.</summary>
    public enum FluidSurfaceLook
    {
        /// <summary>Clear water: refraction, absorption and scattering along the path through it, reflection.</summary>
        Water = 0,

        /// <summary>An opaque body in one colour, for weak devices and stylised pictures.</summary>
        Opaque = 1,
    }
}
