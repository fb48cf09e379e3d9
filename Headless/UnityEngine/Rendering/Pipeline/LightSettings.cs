using System.Collections.Generic;
using UnityEngine.Rendering;
using UnityEngine;

namespace Headless.Engine;

/// <summary>Light and ambient variables of shaders.</summary>
internal static class LightSettings
{
    private static readonly int[] LinearBands = [ShaderNames.Id("unity_SHAr"), ShaderNames.Id("unity_SHAg"), ShaderNames.Id("unity_SHAb")];
    private static readonly int[] QuadraticBands = [ShaderNames.Id("unity_SHBr"), ShaderNames.Id("unity_SHBg"), ShaderNames.Id("unity_SHBb")];
    private static readonly int LastBand = ShaderNames.Id("unity_SHC");
    private static readonly int[] PointPositions =
        [ShaderNames.Id("unity_4LightPosX0"), ShaderNames.Id("unity_4LightPosY0"), ShaderNames.Id("unity_4LightPosZ0")];

    private static readonly int PointAttenuation = ShaderNames.Id("unity_4LightAtten0");
    private static readonly int PointColors = ShaderNames.Id("unity_LightColor");

    /// <summary>Once a camera: ambient light, and the lights outside lit passes.</summary>
    public static void Apply()
    {
        LightReport.OfScene();
        ApplyAmbient();
        ApplyBase(ObjectLights.OfScene);
    }

    /// <summary>What a scriptable pipeline finds set: ambient light, and the sun of the sky.</summary>
    public static void ApplyScene()
    {
        ApplyAmbient();
        ApplySun(LightList.Main);
    }

    /// <summary>The lights of an object's base pass.</summary>
    public static void ApplyBase(ObjectLights lights)
    {
        ApplySun(lights.Main);
        ApplyVertexLights(lights.Vertex);
        ChooseType(LightType.Directional);
        GlobalKeywords.Set("VERTEXLIGHT_ON", lights.Vertex.Count > 0);
    }

    /// <summary>The light of a ForwardAdd pass.</summary>
    public static void ApplyPixel(Light light)
    {
        PropertySheet sheet = GlobalProperties.Sheet;
        Vector3 toward = -light.transform.forward;
        Vector3 place = light.transform.position;
        sheet.SetVector(
            BuiltinNames.LightPosition,
            light.type == LightType.Directional ? new Vector4(toward.x, toward.y, toward.z, 0f) : new Vector4(place.x, place.y, place.z, 1f));
        sheet.SetVector(BuiltinNames.LightColor, light.FinalColor);
        sheet.SetMatrix(BuiltinNames.WorldToLight, WorldToLight(light));
        bool spot = light.type == LightType.Spot;
        Texture first = !spot ? LightTextures.Falloff : light.cookie != null ? light.cookie : LightTextures.Spot;
        sheet.SetTexture(BuiltinNames.LightTexture, new TextureSlot(first));
        sheet.SetTexture(BuiltinNames.LightTextureB, new TextureSlot(LightTextures.Falloff));
        ChooseType(light.type);
        GlobalKeywords.Set("VERTEXLIGHT_ON", false);
    }

    private static void ApplySun(Light? main)
    {
        PropertySheet sheet = GlobalProperties.Sheet;
        Vector3 direction = main != null ? -main.transform.forward : Vector3.up;
        sheet.SetVector(BuiltinNames.LightPosition, new Vector4(direction.x, direction.y, direction.z, 0f));
        sheet.SetVector(BuiltinNames.LightColor, main != null ? main.FinalColor : Color.clear);
    }

    private static void ChooseType(LightType type)
    {
        GlobalKeywords.Set("DIRECTIONAL", type == LightType.Directional);
        GlobalKeywords.Set("POINT", type == LightType.Point);
        GlobalKeywords.Set("SPOT", type == LightType.Spot);
    }

    /// <summary>The range becomes 1; a spot's x / w and y / w go from -0.5 to 0.5 across its cone.</summary>
    private static Matrix4x4 WorldToLight(Light light)
    {
        Matrix4x4 local = Matrix4x4.TRS(light.transform.position, light.transform.rotation, Vector3.one).inverse;
        Matrix4x4 matrix = Matrix4x4.Scale(Vector3.one / Mathf.Max(1e-4f, light.range)) * local;
        if (light.type == LightType.Spot)
        {
            matrix.SetRow(3, matrix.GetRow(2) * (2f * Mathf.Tan(light.spotAngle * 0.5f * Mathf.Deg2Rad)));
        }

        return matrix;
    }

    private static void ApplyVertexLights(IReadOnlyList<Light> lights)
    {
        var positions = new Vector4[3];
        var attenuation = new Vector4();
        var colors = new Vector4[8];
        for (int i = 0; i < lights.Count; i++)
        {
            Vector3 p = lights[i].transform.position;
            (positions[0][i], positions[1][i], positions[2][i]) = (p.x, p.y, p.z);
            attenuation[i] = 25f / Mathf.Max(1e-4f, lights[i].range * lights[i].range);
            colors[i] = lights[i].FinalColor;
        }

        PropertySheet sheet = GlobalProperties.Sheet;
        for (int axis = 0; axis < 3; axis++)
        {
            sheet.SetVector(PointPositions[axis], positions[axis]);
        }

        sheet.SetVector(PointAttenuation, attenuation);
        sheet.SetVectors(PointColors, colors);
    }

    private static void ApplyAmbient()
    {
        (Color sky, Color equator, Color ground) = AmbientLight.Colors();
        PropertySheet sheet = GlobalProperties.Sheet;
        sheet.SetVector(BuiltinNames.AmbientSky, sky);
        sheet.SetVector(BuiltinNames.AmbientEquator, equator);
        sheet.SetVector(BuiltinNames.AmbientGround, ground);

        // UNITY_LIGHTMODEL_AMBIENT is twice this value.
        sheet.SetVector(BuiltinNames.Ambient, (Vector4)sky * 0.5f);

        SphericalHarmonicsL2 probe = RenderSettings.ambientProbe;
        for (int c = 0; c < 3; c++)
        {
            sheet.SetVector(LinearBands[c], new Vector4(probe[c, 3], probe[c, 1], probe[c, 2], probe[c, 0] - probe[c, 6]));
            sheet.SetVector(QuadraticBands[c], new Vector4(probe[c, 4], probe[c, 5], probe[c, 6] * 3f, probe[c, 7]));
        }

        sheet.SetVector(LastBand, new Vector4(probe[0, 8], probe[1, 8], probe[2, 8], 1f));
    }
}
