using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// Draws the surface of a field as the thesis does (6.4.4): one point a cube, its number passed through the vertex
    /// shader, triangles made by the geometry shader, light by the pixel shader.
    /// </summary>
    internal sealed class GeometrySurface : IDisposable
    {
        /// <summary>Its shaders, those of its compute twin among them.</summary>
        public static readonly ShaderGroup Group = new ShaderGroup("the thesis's surface", "Thesis/Shaders/Surface",
            groupThreads: 256, buffers: 4, writableBuffers: 2, groupMemory: 0, vertexBuffers: 0,
            "ResetMCGrid", "SetMCGridDensityFactors", "CountSurfaceVertices", "EmitSurfaceVertices", ShaderName)
        { NeedsGeometryShaders = true };

        private const string ShaderName = "SPH Fluid/Surface (Geometry Shader)";

        // The grid and the tables.
        private const int GeometryBuffers = 2;
        private const string CubesKeyword = "FLUID_CUBES";

        private readonly MaterialPropertyBlock properties = new MaterialPropertyBlock();
        private readonly SceneLighting lighting = new SceneLighting();
        private readonly FluidBuffer tables;
        private Material material;

        /// <exception cref="FluidDeviceException">The device has no geometry shaders, or the shader is
        /// missing.</exception>
        public GeometrySurface(FluidShaderSet shaders)
        {
            string missing = MissingSupport();
            if (missing != null) throw new FluidDeviceException(missing);
            material = DrawMaterial.Create(shaders, ShaderName);
            tables = MarchingCubesTables.CreateBuffer();
        }

        public Material Material => material;

        /// <summary>What this surface needs and the device does not have, as a sentence; null when nothing.</summary>
        public static string MissingSupport()
        {
            DeviceCapabilities device = DeviceCapabilities.Query();
            foreach (string shortfall in Group.Shortfalls(device)) return shortfall;
            if (SystemInfo.maxComputeBufferInputsGeometry < GeometryBuffers)
            {
                return $"{device.Name} cannot read {GeometryBuffers} buffers in the geometry shader, which the thesis's surface needs.";
            }
            return null;
        }

        /// <summary>
        /// Fills the properties of a draw; colour and smoothness only where <paramref name="colour"/> is given.
        /// </summary>
        public MaterialPropertyBlock Properties(SurfaceField field, float isoValue, Color? colour, float smoothness,
            in DrawPlacement placement)
        {
            properties.Clear();
            properties.SetBuffer(field.Buffer.Id, field.Buffer);
            properties.SetBuffer(tables.Id, tables);
            properties.SetGrid(field.Grid, isoValue);
            properties.SetMatrix(RenderShaderIds.FluidLocalToWorld, placement.LocalToWorld);
            if (colour.HasValue)
            {
                properties.SetColor(RenderShaderIds.Color, colour.Value);
                properties.SetFloat(RenderShaderIds.Smoothness, smoothness);
            }
            lighting.Apply(properties);
            DrawPipeline.Apply(properties, placement);
            return properties;
        }

        /// <summary>What the surface's own material draws.</summary>
        public void SetStyle(FluidSurfaceStyle style) =>
            DrawMaterial.SetKeyword(material, CubesKeyword, style == FluidSurfaceStyle.Cubes);

        /// <summary>Draws for every camera of this frame with the properties filled last.</summary>
        public void Draw(SurfaceField field, Material ownMaterial, in DrawPlacement placement)
        {
            DrawPipeline.Prepare(material, placement.Pipeline);
            RenderParams parameters = placement.Parameters(ownMaterial != null ? ownMaterial : material, properties);
            Graphics.RenderPrimitives(parameters, MeshTopology.Points, field.Grid.CubeCount);
        }

        public void Dispose()
        {
            OwnedObject.Destroy(ref material);
            tables.Dispose();
        }
    }
}
