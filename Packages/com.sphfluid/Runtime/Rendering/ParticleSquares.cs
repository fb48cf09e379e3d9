using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// Draws particles as textured, lit squares that face the camera: Fig. 12 of the thesis, left. Needs no geometry shader.
    /// </summary>
    internal sealed class ParticleSquares : IDisposable
    {
        public const int VerticesPerParticle = 6;

        private readonly MaterialPropertyBlock properties = new MaterialPropertyBlock();
        private readonly SceneLighting lighting = new SceneLighting();
        private Material material;
        private Texture2D roundSprite;

        /// <exception cref="FluidDeviceException">The shader is missing, or the device cannot run it.</exception>
        public ParticleSquares(FluidShaderSet shaders)
        {
            if (SystemInfo.maxComputeBufferInputsVertex < 1)
            {
                throw new FluidDeviceException(
                    $"{SystemInfo.graphicsDeviceName} ({SystemInfo.graphicsDeviceType}) cannot read a buffer in the vertex shader; " +
                    "particles cannot be drawn.");
            }
            material = DrawMaterial.Create(shaders, "SPH Fluid/Particles");
            roundSprite = RoundSprite.Create();
        }

        public Material Material => material;

        /// <summary>Fills the properties of a draw of <paramref name="particles"/>.</summary>
        public MaterialPropertyBlock Properties(GraphicsBuffer particles, in ParticleLook look, in DrawPlacement placement)
        {
            properties.SetBuffer(RenderShaderIds.Particles, particles);
            properties.SetTexture(RenderShaderIds.MainTex, look.Sprite != null ? look.Sprite : roundSprite);
            properties.SetColor(RenderShaderIds.Color, look.Color);
            properties.SetColor(RenderShaderIds.FastColor, look.FastColor);
            properties.SetFloat(RenderShaderIds.FastSpeed, look.FastSpeed);
            properties.SetFloat(RenderShaderIds.Smoothness, look.Smoothness);
            properties.SetFloat(RenderShaderIds.ParticleSize, look.Size);
            properties.SetMatrix(RenderShaderIds.FluidLocalToWorld, placement.LocalToWorld);
            lighting.Apply(properties);
            DrawPipeline.Apply(properties, placement);
            return properties;
        }

        /// <summary>Draws for every camera of this frame.</summary>
        public void Draw(GraphicsBuffer particles, int count, in ParticleLook look, in DrawPlacement placement)
        {
            DrawPipeline.Prepare(material, placement.Pipeline);
            RenderParams parameters = placement.Parameters(material, Properties(particles, look, placement));
            Graphics.RenderPrimitives(parameters, MeshTopology.Triangles, count * VerticesPerParticle);
        }

        public void Dispose()
        {
            OwnedObject.Destroy(ref material);
            OwnedObject.Destroy(ref roundSprite);
        }
    }
}
