using UnityEngine;

namespace SphFluid
{
    /// <summary>Property ids of the shaders that draw.</summary>
    internal static class RenderShaderIds
    {
        public static readonly int FluidLocalToWorld = Shader.PropertyToID("_FluidLocalToWorld");
        public static readonly int FluidLightDirection = Shader.PropertyToID("_FluidLightDirection");
        public static readonly int FluidLightColour = Shader.PropertyToID("_FluidLightColour");
        public static readonly int FluidAmbient = Shader.PropertyToID("_FluidAmbient");
        public static readonly int FluidShadowClamp = Shader.PropertyToID("_FluidShadowClamp");
        public static readonly int FluidEye = Shader.PropertyToID("_FluidEye");
        public static readonly int FluidReceived = Shader.PropertyToID("_FluidReceived");
        public static readonly int FluidShadowSource = Shader.PropertyToID("_FluidShadowSource");
        public static readonly int FluidShadowMap = Shader.PropertyToID("_FluidShadowMap");
        public static readonly int FluidShadowConstants = Shader.PropertyToID("_FluidShadowConstants");
        public static readonly int MainLightShadowParams = Shader.PropertyToID("_MainLightShadowParams");
        public static readonly int MainLightShadowmap = Shader.PropertyToID("_MainLightShadowmapTexture");
        public static readonly int Color = Shader.PropertyToID("_Color");
        public static readonly int FastColor = Shader.PropertyToID("_FastColor");
        public static readonly int FastSpeed = Shader.PropertyToID("_FastSpeed");
        public static readonly int Smoothness = Shader.PropertyToID("_Smoothness");
        public static readonly int ParticleSize = Shader.PropertyToID("_ParticleSize");
        public static readonly int Particles = Shader.PropertyToID("_Particles");
        public static readonly int MainTex = Shader.PropertyToID("_MainTex");
        public static readonly int FluidReflectionMap = Shader.PropertyToID("_FluidReflectionMap");
        public static readonly int FluidReflection = Shader.PropertyToID("_FluidReflection");
        public static readonly int FluidReflectionDecode = Shader.PropertyToID("_FluidReflectionDecode");
        public static readonly int FluidThickness = Shader.PropertyToID("_FluidThickness");
        public static readonly int FluidThicknessEyes = Shader.PropertyToID("_FluidThicknessEyes");
        public static readonly int FluidThicknessSize = Shader.PropertyToID("_FluidThicknessSize");
        public static readonly int FluidThicknessView = Shader.PropertyToID("_FluidThicknessView");
        public static readonly int FluidScene = Shader.PropertyToID("_FluidScene");
        public static readonly int FluidSceneHeight = Shader.PropertyToID("_FluidSceneHeight");
        public static readonly int FluidSceneColour = Shader.PropertyToID("_FluidSceneColour");
        public static readonly int FluidExtinction = Shader.PropertyToID("_FluidExtinction");
        public static readonly int FluidScattering = Shader.PropertyToID("_FluidScattering");
        public static readonly int FluidEmission = Shader.PropertyToID("_FluidEmission");
        public static readonly int FluidRefractionSteps = Shader.PropertyToID("_FluidRefractionSteps");
        public static readonly int Refraction = Shader.PropertyToID("_Refraction");
        public static readonly int SprayParticles = Shader.PropertyToID("_SprayParticles");
        public static readonly int DropsPerParticle = Shader.PropertyToID("_DropsPerParticle");
        public static readonly int SprayShutter = Shader.PropertyToID("_SprayShutter");
        public static readonly int SprayColor = Shader.PropertyToID("_SprayColor");
        public static readonly int SprayGlow = Shader.PropertyToID("_SprayGlow");
        public static readonly int SpraySpacing = Shader.PropertyToID("_SpraySpacing");
        public static readonly int ShadowStrength = Shader.PropertyToID("_ShadowStrength");
    }
}
