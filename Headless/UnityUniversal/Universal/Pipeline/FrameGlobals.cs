namespace UnityEngine.Rendering.Universal;

/// <summary>What shaders see of the surroundings, once a frame.</summary>
internal static class FrameGlobals
{
    private static readonly int GlossyColor = Shader.PropertyToID("_GlossyEnvironmentColor");
    private static readonly int GlossyMap = Shader.PropertyToID("_GlossyEnvironmentCubeMap");
    private static readonly int GlossyDecode = Shader.PropertyToID("_GlossyEnvironmentCubeMap_HDR");
    private static readonly int AmbientSky = Shader.PropertyToID("unity_AmbientSky");
    private static readonly int AmbientEquator = Shader.PropertyToID("unity_AmbientEquator");
    private static readonly int AmbientGround = Shader.PropertyToID("unity_AmbientGround");
    private static readonly int SubtractiveShadow = Shader.PropertyToID("_SubtractiveShadowColor");
    private static readonly int RendererColor = Shader.PropertyToID("_RendererColor");

    public static void Set()
    {
        SphericalHarmonicsL2 probe = RenderSettings.ambientProbe;
        var glossy = new Color(probe[0, 0], probe[1, 0], probe[2, 0]) * RenderSettings.reflectionIntensity;
        Shader.SetGlobalVector(GlossyColor, glossy);
        Shader.SetGlobalTexture(GlossyMap, ReflectionProbe.defaultTexture);
        Shader.SetGlobalVector(GlossyDecode, ReflectionProbe.defaultTextureHDRDecodeValues);
        Shader.SetGlobalVector(AmbientSky, RenderSettings.ambientSkyColor.linear);
        Shader.SetGlobalVector(AmbientEquator, RenderSettings.ambientEquatorColor.linear);
        Shader.SetGlobalVector(AmbientGround, RenderSettings.ambientGroundColor.linear);
        Shader.SetGlobalVector(SubtractiveShadow, RenderSettings.subtractiveShadowColor.linear);
        Shader.SetGlobalColor(RendererColor, Color.white);
    }
}
