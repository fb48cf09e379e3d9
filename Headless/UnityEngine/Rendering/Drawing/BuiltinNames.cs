namespace Headless.Engine;

/// <summary>Property numbers of the variables that the engine sets.</summary>
internal static class BuiltinNames
{
    public static readonly int ObjectToWorld = ShaderNames.Id("unity_ObjectToWorld");
    public static readonly int WorldToObject = ShaderNames.Id("unity_WorldToObject");
    public static readonly int WorldTransformParams = ShaderNames.Id("unity_WorldTransformParams");
    public static readonly int LodFade = ShaderNames.Id("unity_LODFade");
    public static readonly int MatrixV = ShaderNames.Id("unity_MatrixV");
    public static readonly int MatrixInvV = ShaderNames.Id("unity_MatrixInvV");
    public static readonly int MatrixVP = ShaderNames.Id("unity_MatrixVP");
    public static readonly int Projection = ShaderNames.Id("glstate_matrix_projection");
    public static readonly int CameraProjection = ShaderNames.Id("unity_CameraProjection");
    public static readonly int CameraInvProjection = ShaderNames.Id("unity_CameraInvProjection");
    public static readonly int WorldToCamera = ShaderNames.Id("unity_WorldToCamera");
    public static readonly int CameraToWorld = ShaderNames.Id("unity_CameraToWorld");
    public static readonly int WorldSpaceCameraPos = ShaderNames.Id("_WorldSpaceCameraPos");
    public static readonly int ProjectionParams = ShaderNames.Id("_ProjectionParams");
    public static readonly int ScreenParams = ShaderNames.Id("_ScreenParams");
    public static readonly int ZBufferParams = ShaderNames.Id("_ZBufferParams");
    public static readonly int OrthoParams = ShaderNames.Id("unity_OrthoParams");
    public static readonly int CameraWorldClipPlanes = ShaderNames.Id("unity_CameraWorldClipPlanes");
    public static readonly int Time = ShaderNames.Id("_Time");
    public static readonly int SinTime = ShaderNames.Id("_SinTime");
    public static readonly int CosTime = ShaderNames.Id("_CosTime");
    public static readonly int DeltaTime = ShaderNames.Id("unity_DeltaTime");
    public static readonly int LightPosition = ShaderNames.Id("_WorldSpaceLightPos0");
    public static readonly int LightColor = ShaderNames.Id("_LightColor0");
    public static readonly int WorldToLight = ShaderNames.Id("unity_WorldToLight");
    public static readonly int LightTexture = ShaderNames.Id("_LightTexture0");
    public static readonly int LightTextureB = ShaderNames.Id("_LightTextureB0");
    public static readonly int LightShadowData = ShaderNames.Id("_LightShadowData");
    public static readonly int LightShadowBias = ShaderNames.Id("unity_LightShadowBias");
    public static readonly int WorldToShadow = ShaderNames.Id("unity_WorldToShadow");
    public static readonly int ShadowSplitSpheres = ShaderNames.Id("unity_ShadowSplitSpheres");
    public static readonly int ShadowSplitSqRadii = ShaderNames.Id("unity_ShadowSplitSqRadii");
    public static readonly int ShadowFadeCenterAndType = ShaderNames.Id("unity_ShadowFadeCenterAndType");
    public static readonly int LightSplitsNear = ShaderNames.Id("_LightSplitsNear");
    public static readonly int LightSplitsFar = ShaderNames.Id("_LightSplitsFar");
    public static readonly int ShadowMap = ShaderNames.Id("_ShadowMapTexture");
    public static readonly int AmbientSky = ShaderNames.Id("unity_AmbientSky");
    public static readonly int AmbientEquator = ShaderNames.Id("unity_AmbientEquator");
    public static readonly int AmbientGround = ShaderNames.Id("unity_AmbientGround");
    public static readonly int Ambient = ShaderNames.Id("glstate_lightmodel_ambient");
    public static readonly int FogColor = ShaderNames.Id("unity_FogColor");
    public static readonly int FogParams = ShaderNames.Id("unity_FogParams");
    public static readonly int LightData = ShaderNames.Id("unity_LightData");
    public static readonly int LightIndices = ShaderNames.Id("unity_LightIndices");
    public static readonly int RenderingLayer = ShaderNames.Id("unity_RenderingLayer");
    public static readonly int MainTex = ShaderNames.Id("_MainTex");
    public static readonly int CameraDepthTexture = ShaderNames.Id("_CameraDepthTexture");
}
