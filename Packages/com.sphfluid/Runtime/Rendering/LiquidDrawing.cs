using System;
using UnityEngine;
using Object = UnityEngine.Object;

namespace SphFluid
{
    /// <summary>Makes the sparse surface of a simulation and draws it, as clear water or as an opaque body.</summary>
    internal sealed class LiquidDrawing : IDisposable
    {
        private readonly FluidShaderSet shaders;
        private readonly SurfaceSource source;
        private WaterDrawing water;
        private OpaqueDrawing opaque;
        private bool caustics = true;

        /// <exception cref="FluidDeviceException">The device cannot make the surface.</exception>
        public LiquidDrawing(FluidShaderSet shaders)
        {
            this.shaders = shaders;
            source = new SurfaceSource(shaders);
            LiquidViews.Add(source);
        }

        /// <summary>Gives up detail in the drawings to come.</summary>
        /// <param name="cellFactor">Edge of a cell over that of the options, 1 or more.</param>
        /// <param name="withCaustics">Whether water has its caustics.</param>
        public void SetDetail(float cellFactor, bool withCaustics) => (source.CellFactor, caustics) = (cellFactor, withCaustics);

        /// <summary>
        /// Draws the surface of the present particles as clear water for every camera of this frame; makes it if one sees it.
        /// </summary>
        public void DrawWater(FluidSolver solver, FluidSurfaceOptions options, FluidWaterLook look, Material ownMaterial,
            in DrawPlacement placement, Object owner)
        {
            Dispose(ref opaque);
            water = water ?? new WaterDrawing(shaders);
            if (!TryFill(water, solver, options, look.Spray, placement, owner, out SurfaceBuffers surface)) return;
            water.SetLook(surface, look, WaterCameras.LargestView, placement, caustics);
            if (ownMaterial == null) water.SetSurface(look);
            water.Draw(surface, ownMaterial, placement);
            if (look.Spray > 0) water.DrawSpray(source.Spray, look, placement);
        }

        /// <summary>
        /// Draws the surface of the present particles as an opaque body for every camera of this frame; makes it if one sees it.
        /// </summary>
        public void DrawOpaque(FluidSolver solver, FluidSurfaceOptions options, Color colour, float smoothness, Material ownMaterial,
            in DrawPlacement placement, Object owner)
        {
            Dispose(ref water);
            opaque = opaque ?? new OpaqueDrawing(shaders);
            if (!TryFill(opaque, solver, options, 0, placement, owner, out SurfaceBuffers surface)) return;
            if (ownMaterial == null) opaque.SetLook(colour, smoothness);
            opaque.Draw(surface, ownMaterial, placement);
        }

        /// <summary>The surface that is drawn.</summary>
        public SparseSurface Surface => source.Surface;

        public void Dispose()
        {
            Dispose(ref water);
            Dispose(ref opaque);
            LiquidViews.Remove(source);
            source.Dispose();
        }

        private bool TryFill(SurfaceDrawing drawing, FluidSolver solver, FluidSurfaceOptions options, int drops, in DrawPlacement placement,
            Object owner, out SurfaceBuffers surface)
        {
            if (!source.Request(solver, options, drops, owner, out surface)) return false;
            LiquidViews.Show(source, placement);
            drawing.Fill(surface, source.Grid, options.Walls, placement);
            return true;
        }

        private static void Dispose<T>(ref T drawing) where T : SurfaceDrawing
        {
            drawing?.Dispose();
            drawing = null;
        }
    }
}
