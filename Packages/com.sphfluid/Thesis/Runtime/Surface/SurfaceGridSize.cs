using UnityEngine;

namespace SphFluid
{
    /// <summary>Cells a side of the grid that the surface is made on; the sizes of the thesis's tables.</summary>
    public enum SurfaceGridSize
    {
        /// <summary>
        /// 128 on a graphics card, 64 where a program on the CPU draws (llvmpipe, SwiftShader, WARP).
        /// </summary>
        Automatic = 0,

        /// <summary>32 cells a side: 36 thousand grid vertices.</summary>
        Cells32 = 32,

        /// <summary>64 cells a side: 275 thousand grid vertices.</summary>
        Cells64 = 64,

        /// <summary>128 cells a side: 2.1 million grid vertices.</summary>
        Cells128 = 128,

        /// <summary>256 cells a side: 17 million grid vertices, 68 MB.</summary>
        Cells256 = 256,
    }

    /// <summary>What a <see cref="SurfaceGridSize"/> means on this device.</summary>
    public static class SurfaceGridSizes
    {
        /// <summary>Cells a side.</summary>
        /// <param name="size">A size; <see cref="SurfaceGridSize.Automatic"/> asks the device.</param>
        /// <returns>32, 64, 128 or 256.</returns>
        public static int Cells(this SurfaceGridSize size)
        {
            Require.Known(size, nameof(size));
            if (size != SurfaceGridSize.Automatic) return (int)size;
            return (int)(FluidSupport.IsSoftwareDevice ? SurfaceGridSize.Cells64 : SurfaceGridSize.Cells128);
        }

        /// <summary>
        /// The grid over the domain of a simulation, which is centred on the origin of simulation space, as the thesis cuts it.
        /// </summary>
        /// <param name="size">Cells a side.</param>
        /// <param name="domainSize">Edges of the domain [m], each greater than zero.</param>
        /// <returns>A grid whose outermost vertices lie on the domain's walls.</returns>
        /// <exception cref="System.ArgumentOutOfRangeException">An edge is not a positive number.</exception>
        public static SurfaceGrid OverDomain(this SurfaceGridSize size, Vector3 domainSize) =>
            new SurfaceGrid(-0.5f * SurfaceGrid.Domain(domainSize), domainSize, size.Cells());
    }
}
