namespace SphFluid
{
    /// <summary>What surface tension needs within a step.</summary>
    internal sealed class TensionBuffers : BufferSet
    {
        /// <summary>Inward normals; their length is what is empty of the kernel's sphere.</summary>
        public readonly FluidBuffer SurfaceNormals;

        public TensionBuffers(int particleCount, bool isPlanned = false) : base(isPlanned)
        {
            SurfaceNormals = Add("SurfaceNormals", particleCount, 16);
        }
    }
}
