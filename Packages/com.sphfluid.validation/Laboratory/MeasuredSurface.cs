using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid.Laboratory
{
    /// <summary>
    /// For measurements only: lights a surface as the package's drawings are lit, with a shader of the measurement's own, so that
    /// surfaces of different makers differ in nothing else.
    /// </summary>
    public sealed class MeasuredSurface : IDisposable
    {
        private readonly MaterialPropertyBlock properties = new MaterialPropertyBlock();
        private readonly SceneLighting lighting = new SceneLighting();
        private Material material;

        /// <summary>For measurements: prepares the drawing.</summary>
        /// <param name="shader">A shader that includes Shaders/Surface/SurfaceShading.hlsl.</param>
        /// <exception cref="FluidDeviceException">The device cannot run the shader.</exception>
        public MeasuredSurface(Shader shader) => material = DrawMaterial.Create(shader);

        /// <summary>The material to draw with.</summary>
        public Material Material => material;

        /// <summary>For measurements: all that the shading reads, simulation space being world space.</summary>
        /// <param name="grid">Grid that the surface was made on.</param>
        /// <param name="vertices">The vertices, as the shader reads them.</param>
        /// <param name="colour">Colour.</param>
        /// <param name="smoothness">Smoothness of the highlight, 0 to 1.</param>
        /// <returns>The properties, valid until the next call.</returns>
        public MaterialPropertyBlock Properties(SurfaceGrid grid, GraphicsBuffer vertices, Color colour, float smoothness)
        {
            DrawPlacement placement = Placement(grid.Size);
            properties.Clear();
            properties.SetGrid(grid, SurfaceWalls.Closed);
            properties.SetMatrix(RenderShaderIds.FluidLocalToWorld, placement.LocalToWorld);
            properties.SetColor(RenderShaderIds.Color, colour);
            properties.SetFloat(RenderShaderIds.Smoothness, smoothness);
            properties.SetBuffer(SurfaceBuffers.VerticesId, vertices);
            lighting.Apply(properties);
            DrawPipeline.Apply(properties, placement);
            return properties;
        }

        /// <summary>Releases the material.</summary>
        public void Dispose() => OwnedObject.Destroy(ref material);

        // Where liquids that are measured stand.
        internal static DrawPlacement Placement(Vector3 domainSize) => new DrawPlacement(Matrix4x4.identity, domainSize, 0f, 0, false);
    }
}
