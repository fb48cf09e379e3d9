namespace SphFluid
{
    /// <summary>The scheme of PySPH that an exported case begins with; each case takes the other by a flag of its own.</summary>
    public enum FluidExportScheme
    {
        /// <summary>Weakly compressible SPH with Tait's equation of state: WCSPHScheme.</summary>
        WeaklyCompressible,

        /// <summary>Entropically damped artificial compressibility (Ramachandran and Puri 2019): EDACScheme.</summary>
        Edac,
    }
}
