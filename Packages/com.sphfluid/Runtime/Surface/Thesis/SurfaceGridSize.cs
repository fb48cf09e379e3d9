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
        // Device names of Mesa's, Google's and Microsoft's rasterisers.
        static readonly string[] SoftwareDevices = { "llvmpipe", "SwiftShader", "Microsoft Basic Render" };

        /// <summary>Whether a program on the CPU draws.</summary>
        internal static bool IsSoftwareDevice
        {
            get
            {
                string device = SystemInfo.graphicsDeviceName;
                return System.Array.Exists(SoftwareDevices,
                    software => device.IndexOf(software, System.StringComparison.OrdinalIgnoreCase) >= 0);
            }
        }

        /// <summary>Cells a side.</summary>
        /// <param name="size">A size; <see cref="SurfaceGridSize.Automatic"/> asks the device.</param>
        /// <returns>32, 64, 128 or 256.</returns>
        public static int Cells(this SurfaceGridSize size)
        {
            Require.Known(size, nameof(size));
            if (size != SurfaceGridSize.Automatic)
                return (int)size;
            return (int)(IsSoftwareDevice ? SurfaceGridSize.Cells64 : SurfaceGridSize.Cells128);
        }
    }
}
