using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// Draws whitewater (Shaders/Whitewater/WhitewaterDrawing.hlsl): once after the water, and once into the picture of the scene that the
    /// water refracts, where bubbles are seen.
    /// </summary>
    internal sealed class WhitewaterDrawing : IBehindWater, IDisposable
    {
        private static readonly int Spacing = Shader.PropertyToID("_WhitewaterSpacing");
        private static readonly int Size = Shader.PropertyToID("_WhitewaterSize");
        private static readonly int Shutter = Shader.PropertyToID("_WhitewaterShutter");
        private static readonly int Phase = Shader.PropertyToID("_WhitewaterPhase");

        // How long the camera's shutter is open for spray [s].
        private const float ShutterTime = 1f / 400f;

        // Periods of the pattern of foam [s], and how many are told apart.
        private const double FoamPeriod = 0.5;
        private const double FoamPeriods = 512.0;

        private readonly MaterialPropertyBlock block = new MaterialPropertyBlock();
        private readonly SceneLighting lighting = new SceneLighting();
        private Material front;
        private Material behind;
        private WhitewaterBuffers buffers;
        private DrawPlacement placement;
        private int preparedAt = -1;

        /// <exception cref="FluidDeviceException">A shader is missing, or the device cannot run it.</exception>
        public WhitewaterDrawing(FluidShaderSet shaders)
        {
            try
            {
                front = DrawMaterial.Create(shaders, "Hidden/SPH Fluid/Whitewater");
                behind = DrawMaterial.Create(shaders, "Hidden/SPH Fluid/Whitewater Behind Water");
            }
            catch (FluidDeviceException)
            {
                DestroyMaterials();
                throw;
            }
            WaterCameras.Add(this);
        }

        /// <summary>Draws the pieces for every camera of this frame, after the water.</summary>
        /// <param name="drawn">The pieces.</param>
        /// <param name="spacing">Particle spacing dx of the liquid [m].</param>
        /// <param name="size">Radius of a piece over that by default.</param>
        /// <param name="colour">Their albedo.</param>
        /// <param name="where">Where they are.</param>
        /// <param name="time">That the liquid has gone [s].</param>
        public void Draw(WhitewaterBuffers drawn, float spacing, float size, Color colour, in DrawPlacement where, double time)
        {
            Fill(drawn, spacing, size, colour, where, time);
            preparedAt = Time.frameCount;
            WaterCameras.ThicknessOf(where)?.Apply(block);
            RenderParams parameters = placement.Parameters(front, block);
            parameters.shadowCastingMode = ShadowCastingMode.Off;
            int times = EyeDraws.Begin();
            for (int i = 0; i < times; i++)
            {
                Graphics.RenderPrimitivesIndirect(EyeDraws.Of(parameters, i), MeshTopology.Triangles, buffers.DrawArguments);
            }
        }

        /// <summary>Sets what is drawn and where, as <see cref="Draw"/> has it, for <see cref="Record"/>.</summary>
        public void Fill(WhitewaterBuffers drawn, float spacing, float size, Color colour, in DrawPlacement where, double time)
        {
            buffers = drawn;
            placement = where;
            block.SetBuffer(buffers.Present.Id, buffers.Present);
            block.SetFloat(Spacing, spacing);
            block.SetFloat(Size, size);
            block.SetFloat(Shutter, ShutterTime);
            block.SetFloat(Phase, (float)(time / FoamPeriod % FoamPeriods));
            ThicknessPass.ApplyNone(block);
            block.SetColor(RenderShaderIds.Color, colour);
            block.SetMatrix(RenderShaderIds.FluidLocalToWorld, placement.LocalToWorld);
            lighting.Apply(block);
            DrawPipeline.Apply(block, placement);
            DrawPipeline.Prepare(front, placement.Pipeline);
        }

        /// <summary>Records the pieces that were filled in last into the present render target.</summary>
        public void Record(CommandBuffer cmd) =>
            cmd.DrawProceduralIndirect(Matrix4x4.identity, front, 0, MeshTopology.Triangles, buffers.DrawArguments, 0, block);

        /// <inheritdoc/>
        public bool IsSeenBy(Camera camera) => preparedAt == Time.frameCount && (camera.cullingMask & (1 << placement.Layer)) != 0 &&
            new ViewVolume(camera).Touches(placement.WorldBounds);

        /// <inheritdoc/>
        public void RecordBehindWater(CommandBuffer cmd, int eye)
        {
            ThicknessPass thickness = WaterCameras.ThicknessOf(placement);
            if (thickness == null) return;
            thickness.Apply(block);
            block.SetFloat(RenderShaderIds.FluidEye, eye);
            cmd.DrawProceduralIndirect(Matrix4x4.identity, behind, 0, MeshTopology.Triangles, buffers.DrawArguments, 0, block);
        }

        public void Dispose()
        {
            WaterCameras.Remove(this);
            DestroyMaterials();
        }

        private void DestroyMaterials()
        {
            OwnedObject.Destroy(ref front);
            OwnedObject.Destroy(ref behind);
        }
    }
}
