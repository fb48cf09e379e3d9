namespace SphFluid
{
    /// <summary>How much work the surface of a liquid may take.</summary>
    public enum FluidSurfaceQuality
    {
        /// <summary>For weak devices: larger cells, plain averages.</summary>
        Cheap = 0,

        /// <summary>Smooth and closed at a moderate cost.</summary>
        Default = 1,

        /// <summary>Finer cells for pictures and powerful devices.</summary>
        High = 2,
    }
}
