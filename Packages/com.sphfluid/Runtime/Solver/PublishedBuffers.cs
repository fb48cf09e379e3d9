namespace SphFluid
{
    /// <summary>
    /// The liquid as drawing, measuring and users read it, whatever the method: particles in the order of their cells, their density and
    /// pressure, the range of each cell of <see cref="FluidGrid"/>, and counts of events.
    /// </summary>
    internal sealed class PublishedBuffers : BufferSet
    {
        /// <summary>Particles in the order of the last sort, <see cref="FluidParticle"/>, live ones first.</summary>
        public readonly FluidBuffer Particles;

        /// <summary>First and end of each cell's particles, uint2, or of those that have any: Shaders/GridCells.hlsl.</summary>
        public readonly FluidBuffer GridIndices;

        /// <summary>Density of each particle [kg/m³].</summary>
        public readonly FluidBuffer Density;

        /// <summary>Pressure of each particle [Pa].</summary>
        public readonly FluidBuffer Pressure;

        /// <summary>Event counts and maxima, see <see cref="FluidCounters"/>.</summary>
        public readonly FluidBuffer Counters;

        /// <summary>An element to bind where the scene has no triangles, and one where it has no meshes.</summary>
        public readonly FluidBuffer NoTriangles, NoColliders;

        public PublishedBuffers(int particleCount, int cellCount, SparseCells sparse, bool isPlanned = false) : base(isPlanned)
        {
            Particles = AddForEach("Particles", particleCount, FluidParticle.Stride);
            const int stride = 2 * sizeof(uint);
            GridIndices = sparse.AreUsed ? AddFor("GridIndices", particleCount, stride, sparse.PublishedCount)
                : Add("GridIndices", cellCount, stride);
            GridIndices.SetData(new uint[2]); // the cells of a method that leaves out some are told by the first
            Density = AddForEach("Density", particleCount, sizeof(float));
            Pressure = AddForEach("Pressure", particleCount, sizeof(float));
            Counters = Add("Counters", CounterReadback.Slots, sizeof(uint));
            Counters.SetData(new uint[CounterReadback.Slots]);
            NoTriangles = Add("NoTriangles", 1, 48);
            NoColliders = Add("NoColliders", 1, 32);
        }
    }
}
