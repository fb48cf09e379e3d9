using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// Draws particles that left the surface as clusters of small drops (Shaders/Rendering/SprayDrops.hlsl): once after the water, and once
    /// into the picture of the scene that the water refracts, so that a sheet of water in front does not hide them.
    /// </summary>
    internal sealed class SprayDrawing : IBehindWater, IDisposable
    {
        private readonly MaterialPropertyBlock block = new MaterialPropertyBlock();
        private readonly SceneLighting lighting = new SceneLighting();
        private Material front;
        private Material behind;
        private SprayBuffers spray;
        private DrawPlacement placement;
        private int preparedAt = -1;

        /// <exception cref="FluidDeviceException">A shader is missing, or the device cannot run it.</exception>
        public SprayDrawing(FluidShaderSet shaders)
        {
            try
            {
                front = DrawMaterial.Create(shaders, "Hidden/SPH Fluid/Spray");
                behind = DrawMaterial.Create(shaders, "Hidden/SPH Fluid/Spray Behind Water");
            }
            catch (FluidDeviceException)
            {
                Dispose();
                throw;
            }
        }

        /// <summary>Draws this frame's spray for every camera, after the water.</summary>
        /// <param name="drawn">The spray.</param>
        /// <param name="look">Its colour and glow, and how long the shutter is open.</param>
        /// <param name="where">Where it is.</param>
        /// <param name="thickness">Of the water.</param>
        public void Draw(in SprayBuffers drawn, FluidWaterLook look, in DrawPlacement where, ThicknessPass thickness)
        {
            Prepare(drawn, look, where, thickness);
            RenderParams parameters = placement.Parameters(front, block);
            parameters.shadowCastingMode = ShadowCastingMode.Off;
            int times = EyeDraws.Begin();
            for (int i = 0; i < times; i++)
            {
                Graphics.RenderPrimitivesIndirect(EyeDraws.Of(parameters, i), MeshTopology.Triangles, spray.Arguments);
            }
        }

        /// <summary>As <see cref="Draw"/>, for what is recorded afterwards.</summary>
        public void Prepare(in SprayBuffers drawn, FluidWaterLook look, in DrawPlacement where, ThicknessPass thickness)
        {
            spray = drawn;
            placement = where;
            preparedAt = Time.frameCount;
            block.SetBuffer(RenderShaderIds.SprayParticles, spray.Particles);
            block.SetInteger(RenderShaderIds.DropsPerParticle, spray.DropsPerParticle);
            block.SetFloat(RenderShaderIds.SprayShutter, look.SprayShutter);
            block.SetVector(RenderShaderIds.SprayColor, look.SprayColor);
            block.SetVector(RenderShaderIds.SprayGlow, look.SprayGlow);
            block.SetFloat(RenderShaderIds.SpraySpacing, spray.Spacing);
            block.SetMatrix(RenderShaderIds.FluidLocalToWorld, placement.LocalToWorld);
            thickness.Apply(block);
            lighting.Apply(block);
            DrawPipeline.Apply(block, placement);
            DrawPipeline.Prepare(front, placement.Pipeline);
        }

        /// <summary>Whether there is spray in this frame that a camera may show.</summary>
        public bool IsSeenBy(Camera camera) => preparedAt == Time.frameCount && (camera.cullingMask & (1 << placement.Layer)) != 0 &&
            new ViewVolume(camera).Touches(placement.WorldBounds);

        /// <summary>Records the spray into the picture of the scene, which is the render target, with the camera's matrices.</summary>
        public void RecordBehindWater(CommandBuffer cmd, int eye)
        {
            block.SetFloat(RenderShaderIds.FluidEye, eye);
            Record(cmd, behind);
        }

        /// <summary>Records the spray after the water, into the render target with its matrices.</summary>
        public void RecordAfterWater(CommandBuffer cmd) => Record(cmd, front);

        private void Record(CommandBuffer cmd, Material material) =>
            cmd.DrawProceduralIndirect(Matrix4x4.identity, material, 0, MeshTopology.Triangles, spray.Arguments, 0, block);

        public void Dispose()
        {
            OwnedObject.Destroy(ref front);
            OwnedObject.Destroy(ref behind);
        }
    }
}
