using System;
using SphFluid.Laboratory;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// Draws a mesh that a compute shader left in buffers, lit per pixel as the thesis's surface is, so that only the surfaces differ.
    /// </summary>
    internal sealed class BenchMeshMaterial : IDisposable
    {
        /// <summary>Pass that reads corners of triangles, see <see cref="DenseSurfaceEmitter"/>.</summary>
        public const int TriangleCornersPass = 0;

        /// <summary>Pass that reads the sparse surface's packed vertices.</summary>
        public const int PackedVerticesPass = 1;

        private const string ShaderPath = "Packages/com.sphfluid.validation/Runtime/Bench/Surface/BenchSurface.shader";

        private readonly MeasuredSurface surface;

        /// <exception cref="FluidDeviceException">The shader is missing, or the device cannot run it.</exception>
        public BenchMeshMaterial(int pass)
        {
            Pass = pass;
            var shader = SessionAssets.Load<Shader>(ShaderPath);
            if (shader == null)
            {
                throw new FluidDeviceException(
                    $"The shader '{ShaderPath}' was not found: the table of surfaces is measured in the Editor and by the headless " +
                    "player only.");
            }
            surface = new MeasuredSurface(shader);
        }

        public Material Material => surface.Material;

        public int Pass { get; }

        /// <summary>All that a drawing of vertices reads.</summary>
        public MaterialPropertyBlock Properties(SurfaceGrid grid, GraphicsBuffer vertices) =>
            surface.Properties(grid, vertices, BenchDrawing.Colour, BenchDrawing.Smoothness);

        public void Dispose() => surface.Dispose();
    }
}
