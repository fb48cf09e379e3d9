using UnityEngine;
using UnityEngine.Rendering;

namespace Headless.Importers.Scenes;

/// <summary>The scene's RenderSettings object: ambient light, sky, sun, fog.</summary>
internal static class SceneSettings
{
    public static void Apply(NativeFields f)
    {
        RenderSettings.Reset();
        RenderSettings.ambientMode = (AmbientMode)f.Int("m_AmbientMode");
        RenderSettings.ambientSkyColor = f.Color("m_AmbientSkyColor", new Color(0.212f, 0.227f, 0.259f));
        RenderSettings.ambientEquatorColor = f.Color("m_AmbientEquatorColor", new Color(0.114f, 0.125f, 0.133f));
        RenderSettings.ambientGroundColor = f.Color("m_AmbientGroundColor", new Color(0.047f, 0.043f, 0.035f));
        RenderSettings.ambientIntensity = f.Float("m_AmbientIntensity", 1);
        RenderSettings.skybox = f.Reference<Material>("m_SkyboxMaterial");
        RenderSettings.sun = f.Reference<Light>("m_Sun");
        RenderSettings.defaultReflectionMode = (DefaultReflectionMode)f.Int("m_DefaultReflectionMode");
        RenderSettings.defaultReflectionResolution = f.Int("m_DefaultReflectionResolution", 128);
        RenderSettings.reflectionIntensity = f.Float("m_ReflectionIntensity", 1);
        RenderSettings.customReflectionTexture = f.Reference<Texture>("m_CustomReflection");
        RenderSettings.fog = f.Bool("m_Fog");
        RenderSettings.fogColor = f.Color("m_FogColor", new Color(0.5f, 0.5f, 0.5f));
        RenderSettings.fogMode = (FogMode)f.Int("m_FogMode", 3);
        RenderSettings.fogDensity = f.Float("m_FogDensity", 0.01f);
        RenderSettings.fogStartDistance = f.Float("m_LinearFogStart");
        RenderSettings.fogEndDistance = f.Float("m_LinearFogEnd", 300);
    }
}
