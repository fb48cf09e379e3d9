using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid.Laboratory
{
    /// <summary>
    /// For measurements only: draws a sparse surface as clear water as a Fluid Surface Renderer does, but into a command buffer.
    /// </summary>
    public sealed class MeasuredWater : IDisposable
    {
        private const int ForwardPass = 0;

        private static readonly int SceneDepth = Shader.PropertyToID("_CameraDepthTexture");

        private readonly WaterDrawing water;
        private SurfaceBuffers buffers;
        private Vector2Int size;

        /// <summary>For measurements: prepares the drawing.</summary>
        /// <param name="shaders">The shaders.</param>
        /// <exception cref="FluidDeviceException">A shader is missing, or the device cannot run it.</exception>
        public MeasuredWater(FluidShaderSet shaders) => water = new WaterDrawing(shaders);

        /// <summary>For measurements: bytes of GPU memory of the thickness picture.</summary>
        public long GpuBytes => water.Thickness.Texture != null ? 8L * water.Thickness.Texture.width * water.Thickness.Texture.height : 0L;

        /// <summary>For measurements: the field of a surface that is drawn like this.</summary>
        /// <param name="quality">Quality of the surface.</param>
        /// <param name="settings">The liquid's constants.</param>
        /// <param name="look">How it looks.</param>
        public static SurfaceFieldSettings FieldOf(FluidSurfaceQuality quality, in FluidSolverSettings settings, FluidWaterLook look) =>
            SurfaceFieldSettings.For(quality, settings).WithSpray(look.Spray > 0);

        /// <summary>
        /// For measurements: takes a surface, and what is behind it, for what is recorded next; simulation space is world space.
        /// </summary>
        /// <param name="surface">The surface, of a field with spray where <paramref name="look"/> has it.</param>
        /// <param name="grid">Its grid.</param>
        /// <param name="spacing">Particle spacing dx [m].</param>
        /// <param name="look">How it looks.</param>
        /// <param name="scene">Picture of what is behind the water, which spray is drawn into.</param>
        /// <param name="depth">Its depth, as the camera's depth texture has it.</param>
        public void Prepare(SparseSurface surface, SurfaceGrid grid, float spacing, FluidWaterLook look, RenderTexture scene, Texture depth)
        {
            DrawPlacement placement = MeasuredSurface.Placement(grid.Size);
            buffers = new SurfaceBuffers(surface.Vertices, surface.Indices, surface.DrawArguments);
            size = new Vector2Int(scene.width, scene.height);
            water.Fill(buffers, grid, SurfaceWalls.Closed, placement);
            water.SetLook(buffers, look, size, placement);
            water.SetSurface(look);
            water.Block.SetTexture(RenderShaderIds.FluidSceneColour, scene);
            water.Block.SetTexture(SceneDepth, depth);
            surface.SprayVertices = look.Spray * SprayBuffers.VerticesPerDrop;
            if (look.Spray > 0)
            {
                water.Spray.Prepare(new SprayBuffers(surface.Spray.Particles, surface.Spray.DrawArguments, look.Spray, spacing),
                    look, placement, water.Thickness);
            }
        }

        /// <summary>For measurements: records how much water lies behind each pixel.</summary>
        /// <param name="cmd">Command buffer; its render target is another afterwards.</param>
        /// <param name="view">World to camera.</param>
        /// <param name="projection">The camera's projection.</param>
        public void RecordThickness(CommandBuffer cmd, Matrix4x4 view, Matrix4x4 projection)
        {
            cmd.SetGlobalVector(RenderShaderIds.FluidScene, new SceneTextures(SceneColourSource.Copy, true).ToVector());
            cmd.SetGlobalVector(RenderShaderIds.FluidThicknessView, new Vector4(size.x, size.y, 0f, 0f));
            water.Thickness.Record(cmd, new CameraViews(view, projection), size);
        }

        /// <summary>For measurements: records the spray that is seen through water; the render target is the scene's picture.</summary>
        /// <param name="cmd">Command buffer whose view is set.</param>
        public void RecordSprayBehind(CommandBuffer cmd) => water.Spray.RecordBehindWater(cmd, 0);

        /// <summary>For measurements: records the water.</summary>
        /// <param name="cmd">Command buffer whose target and view are set.</param>
        public void RecordWater(CommandBuffer cmd) =>
            cmd.DrawProceduralIndirect(buffers.Indices, Matrix4x4.identity, water.Material, ForwardPass, MeshTopology.Triangles,
                buffers.Arguments, 0, water.Block);

        /// <summary>For measurements: records the spray in front of the water.</summary>
        /// <param name="cmd">Command buffer whose target and view are set.</param>
        public void RecordSpray(CommandBuffer cmd) => water.Spray.RecordAfterWater(cmd);

        /// <summary>Releases materials and pictures.</summary>
        public void Dispose() => water.Dispose();
    }
}
