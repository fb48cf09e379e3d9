namespace SphFluid
{
    /// <summary>This version of the package.</summary>
    internal static class FluidPackage
    {
        /// <summary>As package.json has it.</summary>
        public const string Name = "com.sphfluid";

        /// <summary>As package.json has it.</summary>
        public const string Version = "0.2.0";
    }
}
