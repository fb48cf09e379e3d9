using UnityEngine;

namespace SphFluid
{
    /// <summary>Draws a sparse surface as an opaque body.</summary>
    internal sealed class OpaqueDrawing : SurfaceDrawing
    {
        /// <exception cref="FluidDeviceException">The shader is missing, or the device cannot run it.</exception>
        public OpaqueDrawing(FluidShaderSet shaders)
            : base(shaders, "SPH Fluid/Surface")
        {
        }

        /// <summary>Sets colour and smoothness, where no material of the user's does.</summary>
        public void SetLook(Color colour, float smoothness)
        {
            Block.SetColor(RenderShaderIds.Color, colour);
            Block.SetFloat(RenderShaderIds.Smoothness, smoothness);
        }
    }
}
