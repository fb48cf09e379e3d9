using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Draws a sparse surface as clear water, with a thickness picture that is made before each camera draws.</summary>
    internal sealed class WaterDrawing : SurfaceDrawing
    {
        private readonly ThicknessPass thickness;
        private readonly SprayDrawing spray;
        private readonly FluidShaderSet shaders;
        private readonly SceneReflection reflection = new SceneReflection();
        private Material depth;
        private Material within;
        private CausticsDrawing caustics;

        /// <exception cref="FluidDeviceException">A shader is missing, or the device cannot run it.</exception>
        public WaterDrawing(FluidShaderSet shaders)
            : base(shaders, "SPH Fluid/Water")
        {
            this.shaders = shaders;
            try
            {
                depth = DrawMaterial.Create(shaders, "Hidden/SPH Fluid/Water Depth");
                within = DrawMaterial.Create(shaders, "Hidden/SPH Fluid/Water From Within");
                thickness = new ThicknessPass(shaders);
                spray = new SprayDrawing(shaders);
            }
            catch (FluidDeviceException)
            {
                Dispose();
                throw;
            }
            WaterCameras.Add(thickness, spray);
        }

        /// <summary>What draws its spray.</summary>
        public SprayDrawing Spray => spray;

        /// <summary>What draws the water for a camera in it.</summary>
        public Material Within => within;

        /// <summary>Its caustics; null without.</summary>
        public CausticsDrawing Caustics => caustics;

        /// <summary>The thickness picture.</summary>
        public ThicknessPass Thickness => thickness;

        /// <summary>Takes this frame's surface for the thickness picture, and sets what the water looks like and mirrors.</summary>
        public void SetLook(in SurfaceBuffers surface, FluidWaterLook look, Vector2Int largestView, in DrawPlacement placement,
            bool withCaustics = true)
        {
            thickness.Prepare(surface, placement, largestView, look.HalfResolution);
            thickness.Apply(Block);
            reflection.Apply(Block, placement.WorldBounds, look.Smoothness);
            Block.SetVector(RenderShaderIds.FluidExtinction, look.Extinction);
            Vector4 scattering = look.Albedo;
            scattering.w = look.Matt;
            Block.SetVector(RenderShaderIds.FluidScattering, scattering);
            Block.SetVector(RenderShaderIds.FluidEmission, look.Surface);
            Block.SetVector(RenderShaderIds.FluidRefractionSteps, look.RefractionSteps);
            SetCaustics(surface, withCaustics ? look.Caustics : 0f, placement);
        }

        /// <summary>Sets refraction, smoothness and shadow, where no material of the user's does.</summary>
        public void SetSurface(FluidWaterLook look)
        {
            Block.SetFloat(RenderShaderIds.Refraction, look.Refraction);
            Block.SetFloat(RenderShaderIds.Smoothness, look.Smoothness);
            Block.SetFloat(RenderShaderIds.ShadowStrength, look.Shadow);
        }

        /// <summary>Draws this frame's spray.</summary>
        /// <param name="drawn">The spray.</param>
        /// <param name="look">Of the water.</param>
        /// <param name="placement">Where it is.</param>
        public void DrawSpray(in SprayBuffers drawn, FluidWaterLook look, in DrawPlacement placement) =>
            spray.Draw(drawn, look, placement, thickness);

        public override void Draw(in SurfaceBuffers surface, Material ownMaterial, in DrawPlacement placement)
        {
            // Where water is blended, so that only its nearest layer is.
            if (!WaterRoute.Active.IsComplete) DrawUnlit(depth, surface, placement);
            base.Draw(surface, ownMaterial, placement);
            if (WaterCameras.AnyIsNear(thickness)) DrawUnlit(within, surface, placement);
        }

        private void SetCaustics(in SurfaceBuffers surface, float strength, in DrawPlacement placement)
        {
            if (strength > 0f)
            {
                caustics = caustics ?? new CausticsDrawing(shaders);
                caustics.Prepare(surface, Block, placement, strength);
                return;
            }
            caustics?.Dispose();
            caustics = null;
        }

        // One of the passes beside the water's own, which alone casts its shadow.
        private void DrawUnlit(Material material, in SurfaceBuffers surface, in DrawPlacement placement)
        {
            DrawPipeline.Prepare(material, placement.Pipeline);
            RenderParams parameters = placement.Parameters(material, Block);
            parameters.shadowCastingMode = ShadowCastingMode.Off;
            Render(parameters, surface);
        }

        public override void Dispose()
        {
            if (thickness != null)
            {
                WaterCameras.Remove(thickness, spray);
                thickness.Dispose();
            }
            spray?.Dispose();
            caustics?.Dispose();
            OwnedObject.Destroy(ref depth);
            OwnedObject.Destroy(ref within);
            base.Dispose();
        }
    }
}
