using System;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Draws a mesh that a compute shader left in buffers, lit per pixel as the thesis's surface is, so that only the surfaces differ.</summary>
    sealed class BenchMeshMaterial : IDisposable
    {
        /// <summary>Pass that reads corners of triangles, <see cref="EmittedVertex"/> each.</summary>
        public const int TriangleCornersPass = 0;

        /// <summary>Pass that reads the sparse surface's packed vertices.</summary>
        public const int PackedVerticesPass = 1;

        const string ShaderPath = "Packages/com.sphfluid.validation/Runtime/Bench/Surface/BenchSurface.shader";

        readonly MaterialPropertyBlock properties = new MaterialPropertyBlock();
        readonly SceneLighting lighting = new SceneLighting();
        Material material;

        /// <exception cref="FluidDeviceException">The shader is missing, or the device cannot run it.</exception>
        public BenchMeshMaterial(int pass)
        {
            Pass = pass;
            var shader = SessionAssets.Load<Shader>(ShaderPath);
            if (shader == null)
                throw new FluidDeviceException($"The shader '{ShaderPath}' was not found: the table of surfaces is measured in the Editor and by the headless player only.");
            material = DrawMaterial.Create(shader);
        }

        public Material Material => material;

        public int Pass { get; }

        /// <summary>Everything but the vertices.</summary>
        public MaterialPropertyBlock Properties(SurfaceGrid grid, in DrawPlacement placement)
        {
            properties.Clear();
            properties.SetGrid(grid, SurfaceWalls.Closed);
            properties.SetMatrix(RenderShaderIds.FluidLocalToWorld, placement.LocalToWorld);
            properties.SetColor(RenderShaderIds.Color, BenchDrawing.Colour);
            properties.SetFloat(RenderShaderIds.Smoothness, BenchDrawing.Smoothness);
            lighting.Apply(properties);
            DrawPipeline.Apply(properties, placement.Pipeline);
            return properties;
        }

        public void Dispose() => DrawMaterial.Destroy(ref material);
    }
}
