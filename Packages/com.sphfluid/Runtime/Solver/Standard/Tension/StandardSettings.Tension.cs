namespace SphFluid
{
    // What surface tension adds.
    public partial struct StandardSettings
    {
        /// <summary>Surface tension σ [N/m]; 0: none.</summary>
        public float SurfaceTension;

        /// <summary>
        /// Angle between walls and the liquid's surface, measured in the liquid [degrees], 0 to 180: below 90 the liquid wets them. Acts
        /// with <see cref="SurfaceTension"/>.
        /// </summary>
        public float ContactAngle;
    }
}
