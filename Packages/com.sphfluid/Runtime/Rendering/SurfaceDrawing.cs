using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>Draws a sparse surface for every camera of a frame: what its looks have in common.</summary>
    internal abstract class SurfaceDrawing : IDisposable
    {
        private readonly SceneLighting lighting = new SceneLighting();
        private Material material;

        /// <exception cref="FluidDeviceException">The shader is missing, or the device cannot run it.</exception>
        protected SurfaceDrawing(FluidShaderSet shaders, string shader)
        {
            string shortfall = MissingSupport();
            if (shortfall != null) throw new FluidDeviceException(shortfall);
            material = DrawMaterial.Create(shaders, shader);
        }

        public Material Material => material;

        /// <summary>The properties filled last.</summary>
        public MaterialPropertyBlock Block { get; } = new MaterialPropertyBlock();

        /// <summary>What keeps the device from drawing a sparse surface, as a sentence; null when nothing.</summary>
        public static string MissingSupport()
        {
            DeviceCapabilities device = DeviceCapabilities.Query();
            foreach (string shortfall in ShaderGroup.Drawing.Shortfalls(device)) return shortfall;
            foreach (string shortfall in ShaderGroup.Surface.Shortfalls(device)) return shortfall;
            if (!SystemInfo.supportsIndirectArgumentsBuffer)
            {
                return $"{device.Name} cannot draw what the GPU has counted, which the surface needs.";
            }
            return null;
        }

        /// <summary>Draws for every camera of this frame with the properties filled last.</summary>
        public virtual void Draw(in SurfaceBuffers surface, Material ownMaterial, in DrawPlacement placement)
        {
            DrawPipeline.Prepare(material, placement.Pipeline);
            Render(placement.Parameters(ownMaterial != null ? ownMaterial : material, Block), surface);
        }

        public virtual void Dispose() => OwnedObject.Destroy(ref material);

        protected static void Render(in RenderParams parameters, in SurfaceBuffers surface)
        {
            int times = EyeDraws.Begin();
            for (int i = 0; i < times; i++)
            {
                Graphics.RenderPrimitivesIndexedIndirect(EyeDraws.Of(parameters, i), MeshTopology.Triangles, surface.Indices,
                    surface.Arguments);
            }
        }

        /// <summary>Fills what every look needs.</summary>
        public void Fill(in SurfaceBuffers surface, in SurfaceGrid grid, SurfaceWalls walls, in DrawPlacement placement)
        {
            Block.Clear();
            Block.SetBuffer(SurfaceBuffers.VerticesId, surface.Vertices);
            Block.SetGrid(grid, walls);
            Block.SetMatrix(RenderShaderIds.FluidLocalToWorld, placement.LocalToWorld);
            lighting.Apply(Block);
            DrawPipeline.Apply(Block, placement);
        }
    }
}
