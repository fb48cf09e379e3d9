namespace SphFluid
{
    /// <summary>Where particles come to rest on triangles, and how far contact follows them in a step.</summary>
    internal static class ContactDistances
    {
        // Over dx, where particles come to rest on triangles.
        private const float RestRatio = 0.1f;

        // Over dx: displacements that contact follows in a step; longer ones are shortened and counted.
        private const float LongestRatio = 8f;

        /// <summary>Where particles come to rest [m].</summary>
        public static float Rest(in FluidSolverSettings settings) => RestRatio * settings.Spacing;

        /// <summary>Longest displacement of a step [m].</summary>
        public static float LongestDisplacement(in FluidSolverSettings settings) => LongestRatio * settings.Spacing;
    }
}
