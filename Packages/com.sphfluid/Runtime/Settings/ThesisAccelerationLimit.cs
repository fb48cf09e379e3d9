namespace SphFluid
{
    /// <summary>What limits the fluid's own acceleration in step 6.3.3, lines 04 to 06.</summary>
    public enum ThesisAccelerationLimit
    {
        /// <summary>Nothing.</summary>
        Off = 0,

        /// <summary>One spacing a step, dx/dt²: an emergency that normal runs never come to; it is counted.</summary>
        Emergency = 1,

        /// <summary>As printed: MaxVelocity, a speed in m/s, is taken for an acceleration in m/s².</summary>
        AsPrinted = 2,
    }
}
