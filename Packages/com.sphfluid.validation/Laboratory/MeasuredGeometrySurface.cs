using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid.Laboratory
{
    /// <summary>
    /// For measurements only: draws the thesis's surface as a Fluid Geometry Surface Renderer does, but into a command buffer.
    /// </summary>
    public sealed class MeasuredGeometrySurface : IDisposable
    {
        private const int ForwardPass = 0;

        private readonly GeometrySurface surface;

        /// <summary>For measurements: prepares the drawing.</summary>
        /// <param name="shaders">The shaders.</param>
        /// <exception cref="FluidDeviceException">See <see cref="MissingSupport"/>, or a shader is missing.</exception>
        public MeasuredGeometrySurface(FluidShaderSet shaders) => surface = new GeometrySurface(shaders);

        /// <summary>For measurements: what the drawing needs and this device does not have.</summary>
        /// <returns>A sentence; null when nothing is missing.</returns>
        public static string MissingSupport() => GeometrySurface.MissingSupport();

        /// <summary>For measurements: records the drawing of a field's surface, simulation space being world space.</summary>
        /// <param name="cmd">Command buffer whose target and view are set.</param>
        /// <param name="field">The field.</param>
        /// <param name="isoValue">Its value on the surface.</param>
        /// <param name="colour">Colour.</param>
        /// <param name="smoothness">Smoothness of the highlight, 0 to 1.</param>
        public void Record(CommandBuffer cmd, SurfaceField field, float isoValue, Color colour, float smoothness)
        {
            MaterialPropertyBlock properties =
                surface.Properties(field, isoValue, colour, smoothness, MeasuredSurface.Placement(field.Grid.Size));
            cmd.DrawProcedural(Matrix4x4.identity, surface.Material, ForwardPass, MeshTopology.Points, field.Grid.CubeCount, 1, properties);
        }

        /// <summary>Releases the material.</summary>
        public void Dispose() => surface.Dispose();
    }
}
