namespace SphFluid
{
    /// <summary>Which way the axes of particle files point that come from elsewhere.</summary>
    public enum FluidSequenceAxes
    {
        /// <summary>As Unity's: x right, y up, z forward, left-handed.</summary>
        AsUnity,

        /// <summary>Right-handed, y up: z is turned round.</summary>
        RightHandedYUp,

        /// <summary>Right-handed, z up: y and z change places.</summary>
        RightHandedZUp,
    }
}
