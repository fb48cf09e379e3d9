using Headless.Tests.Rendering;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;

namespace Headless.Tests.Conformance;

/// <summary>Lights of Unity's Built-in forward rendering; what is not drawn is named.</summary>
public sealed class LightTests : SceneFixture
{
    // Lambert's light of every pass, as linear numbers.
    private const string Lambert = """
        Shader "Test/Lambert"
        {
            SubShader
            {
                HLSLINCLUDE
                #include "UnityCG.cginc"
                #include "AutoLight.cginc"
                float4 _LightColor0;
                struct V { float4 vertex : POSITION; float3 normal : NORMAL; };
                struct F { float4 pos : SV_POSITION; float3 world : TEXCOORD0; float3 normal : TEXCOORD1; float3 dots : TEXCOORD2; UNITY_LIGHTING_COORDS(3, 4) };
                F Vertex(V v)
                {
                    F o;
                    o.pos = UnityObjectToClipPos(v.vertex.xyz);
                    o.world = mul(unity_ObjectToWorld, v.vertex).xyz;
                    o.normal = UnityObjectToWorldNormal(v.normal);
                    o.dots = 0;
                #ifdef VERTEXLIGHT_ON
                    o.dots = Shade4PointLights(unity_4LightPosX0, unity_4LightPosY0, unity_4LightPosZ0, unity_LightColor[0].rgb,
                        unity_LightColor[1].rgb, unity_LightColor[2].rgb, unity_LightColor[3].rgb, unity_4LightAtten0, o.world, o.normal);
                #endif
                    UNITY_TRANSFER_LIGHTING(o, float2(0, 0))
                    return o;
                }
                float4 Fragment(F i) : SV_Target
                {
                    UNITY_LIGHT_ATTENUATION(visible, i, i.world)
                    float cosine = saturate(dot(normalize(i.normal), normalize(UnityWorldSpaceLightDir(i.world))));
                    return float4(_LightColor0.rgb * cosine * visible + i.dots, 1);
                }
                ENDHLSL
                Pass
                {
                    Tags { "LightMode" = "ForwardBase" }
                    HLSLPROGRAM
                    #pragma vertex Vertex
                    #pragma fragment Fragment
                    #pragma multi_compile_fwdbase
                    ENDHLSL
                }
                //ADD
            }
        }
        """;

    private const string Additive = """
        Pass
        {
            Tags { "LightMode" = "ForwardAdd" }
            Blend One One
            ZWrite Off
            HLSLPROGRAM
            #pragma vertex Vertex
            #pragma fragment Fragment
            #pragma multi_compile_fwdadd
            ENDHLSL
        }
        """;

    private RenderTexture? target;

    private static Light Lamp(string name, LightType type, Vector3 place)
    {
        var light = new GameObject(name).AddComponent<Light>();
        light.type = type;
        light.transform.position = place;
        light.transform.rotation = Quaternion.LookRotation(Vector3.down);
        return light;
    }

    /// <summary>A floor of 10 m seen from above, 1 m a pixel of the height.</summary>
    private Camera Floor(bool additive = true)
    {
        RenderSettings.ambientMode = AmbientMode.Flat;
        RenderSettings.ambientLight = Color.black;
        Camera camera = Camera(new Vector3(0f, 5f, 0f), Vector3.zero);
        camera.transform.rotation = Quaternion.LookRotation(Vector3.down, Vector3.forward);
        (camera.orthographic, camera.orthographicSize, camera.allowMSAA) = (true, 4f, false);
        target = new RenderTexture(64, 64, 24, RenderTextureFormat.ARGBFloat, RenderTextureReadWrite.Linear);
        camera.targetTexture = target;
        Primitive(PrimitiveType.Plane, Vector3.zero).GetComponent<Renderer>().sharedMaterial =
            MaterialOf(additive ? Lambert.Replace("//ADD", Additive, StringComparison.Ordinal) : Lambert);
        return camera;
    }

    /// <summary>Linear light at a point of the floor.</summary>
    private Color At(float x, float z)
    {
        RenderTexture? active = RenderTexture.active;
        RenderTexture.active = target;
        var copy = new Texture2D(64, 64, TextureFormat.RGBAFloat, false, true);
        copy.ReadPixels(new Rect(0, 0, 64, 64), 0, 0, false);
        RenderTexture.active = active;
        return copy.GetPixel((int)((x + 4f) * 8f), (int)((z + 4f) * 8f));
    }

    /// <summary>Light that falls on the middle of the pixel of a point from a lamp above, by the formula of Unity's falloff.</summary>
    private static float FromAbove(Light lamp, float x, float z)
    {
        Vector3 middle = new(((int)((x + 4f) * 8f) / 8f) - 3.9375f, 0f, ((int)((z + 4f) * 8f) / 8f) - 3.9375f);
        Vector3 to = lamp.transform.position - middle;
        float share = to.magnitude / lamp.range;
        float falloff = Math.Clamp((1f - share) * 5f, 0f, 1f) / (1f + (25f * share * share));
        return lamp.FinalColor.r * falloff * to.normalized.y;
    }

    [Test]
    public void APointLightLightsWhatLiesInItsRange()
    {
        Floor();
        Light lamp = Lamp("Lamp", LightType.Point, new Vector3(0f, 1f, 0f));
        lamp.range = 3f;
        lamp.intensity = 2f;
        Frame();
        foreach ((float x, float z) in new[] { (0f, 0f), (1f, 0.5f), (-1.5f, 1.5f), (2.5f, 0f), (3.5f, 3.5f) })
        {
            float expected = FromAbove(lamp, x, z);
            Assert.That(At(x, z).r, Is.EqualTo(expected).Within(1e-3f + (0.02f * expected)), $"at {x}, {z}");
        }

        Assert.That(At(3.5f, 3.5f).r, Is.Zero, "beyond the range");
        Assert.That(Warnings, Is.Empty);
    }

    [Test]
    public void FurtherDirectionalLightsAreAdded()
    {
        Floor();
        Sun(Vector3.down).shadows = LightShadows.None;
        Light second = Lamp("Second", LightType.Directional, Vector3.zero);
        second.transform.rotation = Quaternion.LookRotation(new Vector3(1f, -1f, 0f));
        (second.color, second.intensity) = (Color.red, 0.5f);
        Frame();
        Color seen = At(0f, 0f);
        Assert.That(seen.g, Is.EqualTo(1f).Within(1e-3f));
        Assert.That(seen.r, Is.EqualTo(1f + (second.FinalColor.r * Mathf.Sqrt(0.5f))).Within(1e-3f));
        Assert.That(Warnings, Is.Empty);
    }

    [Test]
    public void ASpotLightLightsItsConeOnly()
    {
        Floor();
        Light lamp = Lamp("Lamp", LightType.Spot, new Vector3(1f, 2f, 0f));
        (lamp.range, lamp.spotAngle, lamp.intensity) = (6f, 60f, 2f);
        Frame();
        // Its radius on the floor is 2 tan 30 degrees = 1.15 m, of which the inner 0.8 m have all of its light.
        foreach ((float x, float z) in new[] { (1f, 0f), (1.5f, 0.3f), (0.4f, -0.3f) })
        {
            float expected = FromAbove(lamp, x, z);
            Assert.That(At(x, z).r, Is.EqualTo(expected).Within(0.02f * expected), $"at {x}, {z}");
        }

        Assert.That(At(2.05f, 0f).r, Is.GreaterThan(0f).And.LessThan(0.5f * FromAbove(lamp, 2.05f, 0f)), "the soft edge");
        Assert.That(At(2.3f, 0f).r, Is.Zero, "outside its cone");
        Assert.That(At(-1f, 0f).r, Is.Zero, "on the other side");
        Assert.That(Warnings, Is.Empty);
    }

    [Test]
    public void ACookieOfASpotLightIsDrawn()
    {
        Floor();
        Light lamp = Lamp("Lamp", LightType.Spot, new Vector3(0f, 2f, 0f));
        (lamp.range, lamp.spotAngle) = (6f, 60f);
        var half = new Texture2D(2, 1, TextureFormat.RGBA32, false, true) { wrapMode = TextureWrapMode.Clamp, filterMode = FilterMode.Point };
        half.SetPixels([new Color(0f, 0f, 0f, 1f), new Color(0f, 0f, 0f, 0f)]);
        half.Apply();
        lamp.cookie = half;
        Frame();
        Vector3 left = -lamp.transform.right;
        Assert.That(At(left.x * 0.5f, left.z * 0.5f).r, Is.GreaterThan(0.1f));
        Assert.That(At(left.x * -0.5f, left.z * -0.5f).r, Is.Zero);
        Assert.That(Warnings, Is.Empty);
    }

    [Test]
    public void StandardAndDiffuseMaterialsShowFurtherLights([Values("Standard", "Standard (Specular setup)", "Legacy Shaders/Diffuse")] string shader)
    {
        Camera camera = Camera(new Vector3(0f, 6f, -4f), Vector3.zero);
        RenderSettings.ambientMode = AmbientMode.Flat;
        RenderSettings.ambientLight = Color.black;
        Sun(new Vector3(0.3f, -1f, 0.5f)).intensity = 0.3f;
        Light second = Lamp("Second", LightType.Directional, Vector3.zero);
        (second.color, second.intensity) = (Color.red, 0.2f);
        Light spot = Lamp("Spot", LightType.Spot, new Vector3(-1.5f, 3f, 0f));
        (spot.color, spot.intensity, spot.spotAngle, spot.range) = (Color.green, 3f, 40f, 8f);
        Light point = Lamp("Point", LightType.Point, new Vector3(2f, 1f, 0f));
        (point.color, point.intensity, point.range) = (Color.blue, 2f, 3f);
        var material = new Material(Shader.Find(shader));
        Primitive(PrimitiveType.Plane, Vector3.zero).GetComponent<Renderer>().sharedMaterial = material;
        Primitive(PrimitiveType.Sphere, new Vector3(0f, 0.5f, 0f)).GetComponent<Renderer>().sharedMaterial = material;
        Frame();
        Picture picture = Picture.OfScreen().Keep("lights-" + shader.Replace('/', ' '));
        Color32 apart = picture.At(camera.WorldToScreenPoint(new Vector3(0f, 0f, 3f)));
        Color32 cone = picture.At(camera.WorldToScreenPoint(new Vector3(-1.5f, 0f, 0f)));
        Color32 lamp = picture.At(camera.WorldToScreenPoint(new Vector3(2f, 0f, 0f)));
        Assert.That(apart.r, Is.GreaterThan(apart.g + 10), "the red light from above");
        Assert.That(cone.g, Is.GreaterThan(apart.g + 40), "the spot");
        Assert.That(lamp.b, Is.GreaterThan(apart.b + 40), "the point light");
        Assert.That(Warnings, Is.Empty);
    }

    [Test]
    public void AnUnimportantPointLightIsAVertexLightOfTheBasePass([Values] bool additive)
    {
        Floor(additive);
        Light lamp = Lamp("Lamp", LightType.Point, new Vector3(0f, 1f, 0f));
        lamp.range = 6f;
        lamp.renderMode = additive ? LightRenderMode.ForceVertex : LightRenderMode.Auto;
        Frame();

        // The plane's vertices are 1 m apart, one is at 0, 0: light / (1 + 25 / range^2 d^2).
        Assert.That(At(0.01f, 0.01f).r, Is.EqualTo(1f / (1f + (25f / 36f))).Within(0.05f));
        Assert.That(Warnings, Is.Empty);
    }

    [Test]
    public void ALayerOutsideALightsMaskStaysDark()
    {
        Floor();
        Light lamp = Lamp("Lamp", LightType.Directional, Vector3.up);
        lamp.cullingMask = ~1;
        Lamp("Spot", LightType.Spot, Vector3.up).cullingMask = ~1;
        Frame();
        Assert.That(At(0f, 0f).r, Is.Zero);
    }

    [TestCase(LightType.Directional, false, LightRenderMode.Auto, "no ForwardAdd pass")]
    [TestCase(LightType.Spot, false, LightRenderMode.ForcePixel, "no ForwardAdd pass")]
    [TestCase(LightType.Spot, true, LightRenderMode.ForceVertex, "Not Important")]
    [TestCase(LightType.Directional, true, LightRenderMode.Auto, "pixelLightCount is 1")]
    public void WhatUnityAddsToTheAmbientLightIsNamedOnce(LightType type, bool additive, LightRenderMode mode, string reason)
    {
        Floor(additive);
        Sun(Vector3.down).intensity = 2f;
        Lamp("Second", type, Vector3.up).renderMode = mode;
        int count = QualitySettings.pixelLightCount;
        QualitySettings.pixelLightCount = 1;
        Frame(3);
        QualitySettings.pixelLightCount = count;
        Assert.That(Warnings.Where(w => w.Contains("Second")).Single(), Does.Contain(reason));
        Assert.That(At(0f, 0f).r, Is.EqualTo(Mathf.GammaToLinearSpace(2f)).Within(0.01f), "the sun alone");
    }

    [Test]
    public void BakedAndAreaLightsCookiesAndShadowsAreNamed()
    {
        Floor();
        Sun(Vector3.down).cookie = Texture2D.whiteTexture;
        Lamp("Bulb", LightType.Point, Vector3.up).lightmapBakeType = LightmapBakeType.Baked;
        Lamp("Panel", LightType.Rectangle, Vector3.up);
        Lamp("Lamp", LightType.Spot, Vector3.up).shadows = LightShadows.Soft;
        Frame(2);
        Assert.That(Warnings, Has.Exactly(1).Contains("'Bulb' is baked"));
        Assert.That(Warnings, Has.Exactly(1).Contains("'Panel' is not drawn: Rectangle lights are not supported"));
        Assert.That(Warnings, Has.Exactly(1).Contains("'Sun' is drawn without its cookie"));
        Assert.That(Warnings, Has.Exactly(1).Contains("'Lamp' casts no shadow here"));
        Assert.That(Warnings, Has.Count.EqualTo(4));
    }

    [Test]
    public void TheBrightestLightsArePixelLightsAndTheNextFourVertexLights()
    {
        Floor();
        for (int i = 0; i < 10; i++)
        {
            Lamp($"Point {i}", LightType.Point, Vector3.up).intensity = 10 - i;
        }

        Frame();

        // Four pixel lights and four vertex lights.
        Assert.That(Warnings.Select(w => w[..w.IndexOf(" is", StringComparison.Ordinal)]), Is.EqualTo(new[] { "[Warning] Light 'Point 8'", "[Warning] Light 'Point 9'" }));
    }
}
