namespace SphFluid
{
    // What the drag of air adds.
    public partial struct StandardSettings
    {
        /// <summary>Density of the still air around the liquid [kg/m³]; 0: no drag.</summary>
        public float AirDensity;
    }
}
