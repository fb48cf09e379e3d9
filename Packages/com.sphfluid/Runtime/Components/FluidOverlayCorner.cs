namespace SphFluid
{
    /// <summary>Corner of the screen that the overlay stands in.</summary>
    public enum FluidOverlayCorner
    {
        /// <summary>Upper left.</summary>
        UpperLeft = 0,

        /// <summary>Upper right.</summary>
        UpperRight = 1,

        /// <summary>Lower left.</summary>
        LowerLeft = 2,

        /// <summary>Lower right.</summary>
        LowerRight = 3,
    }
}
