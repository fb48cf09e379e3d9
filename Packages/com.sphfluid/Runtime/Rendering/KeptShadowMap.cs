using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// Built-in pipeline: the shadow map of a directional light, kept for what is drawn after the opaque things. Command buffers on the
    /// light give the map a name of the package's own once it is drawn (<see cref="LightEvent.AfterShadowMap"/>, where it is the render
    /// target), and copy the variables that place it into a small texture while they are set
    /// (<see cref="LightEvent.BeforeScreenspaceMask"/>). Where the pipeline makes no screen space mask, as on devices without cascaded
    /// shadows, the second does not run, and everything counts as lit.
    /// </summary>
    internal sealed class KeptShadowMap : IDisposable
    {
        // Pixels that ShadowConstants.hlsl fills.
        private const int Constants = 24;

        private readonly CommandBuffer keep = new CommandBuffer { name = "Fluid Shadow Map" };
        private readonly CommandBuffer copy = new CommandBuffer { name = "Fluid Shadow Constants" };
        private Material material;
        private RenderTexture constants;
        private float recorded = MainLightShadows.None;

        /// <exception cref="FluidDeviceException">The shader is missing, or the device cannot run it.</exception>
        public KeptShadowMap(FluidShaderSet shaders)
        {
            material = DrawMaterial.Create(shaders, "Hidden/SPH Fluid/Shadow Constants");
            keep.SetGlobalTexture(RenderShaderIds.FluidShadowMap, BuiltinRenderTextureType.CurrentActive);
        }

        /// <summary>The light whose map is kept; null where there is none.</summary>
        public Light Light { get; private set; }

        /// <summary>Keeps the map of this light from now on; of none where it is null or casts no shadows.</summary>
        public void Watch(Light light)
        {
            Light wanted = light != null && light.shadows != LightShadows.None &&
                QualitySettings.shadows != ShadowQuality.Disable ? light : null;
            if (wanted != Light || (wanted == null && !ReferenceEquals(Light, null)))
            {
                Leave();
                if (wanted != null) Attach(wanted);
            }
            if (wanted != null && recorded != Kind()) Record();
        }

        public void Dispose()
        {
            Leave();
            keep.Dispose();
            copy.Dispose();
            OwnedObject.Destroy(ref material);
        }

        private void Attach(Light light)
        {
            constants = new RenderTexture(Constants, 1, 0, RenderTextureFormat.ARGBFloat, RenderTextureReadWrite.Linear)
            {
                name = "Fluid Shadow Constants",
                hideFlags = HideFlags.HideAndDontSave,
                filterMode = FilterMode.Point,
            };
            recorded = MainLightShadows.None;
            Light = light;
            light.AddCommandBuffer(LightEvent.AfterShadowMap, keep);
            light.AddCommandBuffer(LightEvent.BeforeScreenspaceMask, copy);
        }

        private void Leave()
        {
            if (Light != null)
            {
                Light.RemoveCommandBuffer(LightEvent.AfterShadowMap, keep);
                Light.RemoveCommandBuffer(LightEvent.BeforeScreenspaceMask, copy);
            }
            if (!ReferenceEquals(Light, null)) NoShadowMap.Restore();
            Light = null;
            if (constants != null) constants.Release();
            OwnedObject.Destroy(ref constants);
        }

        private void Record()
        {
            recorded = Kind();
            copy.Clear();
            copy.SetRenderTarget(constants);
            copy.DrawProcedural(Matrix4x4.identity, material, 0, MeshTopology.Triangles, 3);
            copy.SetGlobalTexture(RenderShaderIds.FluidShadowConstants, constants);
            copy.SetGlobalVector(RenderShaderIds.FluidShadowSource, new Vector4(recorded, 0f, 0f, 0f));
        }

        // How the pipeline divides the map.
        private static float Kind()
        {
            if (QualitySettings.shadowCascades <= 1) return MainLightShadows.Whole;
            return QualitySettings.shadowProjection == ShadowProjection.StableFit ? MainLightShadows.BySpheres : MainLightShadows.ByDepth;
        }
    }
}
