using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;

namespace Headless.Tests.Rendering;

/// <summary>Command buffers on the main light: when they run, and what they find.</summary>
public sealed class LightCommandTests : SceneFixture
{
    // Green in the light and red in the shadow, by the map that a command buffer has kept.
    private const string Receiver = """
        Shader "Test/Receiver"
        {
            SubShader
            {
                Tags { "Queue" = "Transparent" }
                Pass
                {
                    HLSLPROGRAM
                    #pragma vertex Vertex
                    #pragma fragment Fragment
                    #include "UnityCG.cginc"
                    Texture2D _Kept;
                    SamplerComparisonState sampler_LinearClampCompare;
                    struct Varyings { float4 position : SV_POSITION; float3 world : TEXCOORD0; };
                    Varyings Vertex(float4 position : POSITION)
                    {
                        Varyings o;
                        o.position = UnityObjectToClipPos(position);
                        o.world = mul(unity_ObjectToWorld, position).xyz;
                        return o;
                    }
                    float4 Fragment(Varyings i) : SV_Target
                    {
                        float3 place = mul(unity_WorldToShadow[0], float4(i.world, 1.0)).xyz;
                        float3 away = i.world - unity_ShadowSplitSpheres[0].xyz;
                        bool inside = dot(away, away) < unity_ShadowSplitSqRadii.x && _LightSplitsNear.x < 5.0 && _LightSplitsFar.x > 5.0;
                        float lit = _Kept.SampleCmpLevelZero(sampler_LinearClampCompare, place.xy, place.z);
                        return float4(1.0 - lit, lit, inside ? 0.0 : 1.0, 1.0);
                    }
                    ENDHLSL
                }
            }
        }
        """;

    private static readonly int Last = Shader.PropertyToID("_LastEvent");

    [Test]
    public void TheShadowMapIsTheTargetOnceItIsDrawn()
    {
        Camera camera = Camera(new Vector3(0f, 5f, 0f), Vector3.zero);
        Light sun = Sun(Vector3.down);
        Primitive(PrimitiveType.Cube, new Vector3(0f, 1f, 0f)).GetComponent<Renderer>().shadowCastingMode = ShadowCastingMode.ShadowsOnly;
        GameObject floor = GameObject.CreatePrimitive(PrimitiveType.Plane);
        floor.GetComponent<Renderer>().sharedMaterial = MaterialOf(Receiver);
        floor.GetComponent<Renderer>().shadowCastingMode = ShadowCastingMode.Off;
        using var keeping = new CommandBuffer();
        keeping.SetGlobalTexture("_Kept", BuiltinRenderTextureType.CurrentActive);
        sun.AddCommandBuffer(LightEvent.AfterShadowMap, keeping);
        Frame();
        Picture picture = Picture.OfScreen().Keep("kept-shadow-map");
        Assert.That(IsRed(picture.At(camera.WorldToScreenPoint(Vector3.zero))), Is.True, "under the cube");
        Assert.That(IsGreen(picture.At(camera.WorldToScreenPoint(new Vector3(0.7f, 0f, 0f)))), Is.True, "beside it");
    }

    [Test]
    public void TheyRunInOrderAndOnlyForAMapThatIsDrawn()
    {
        Camera(new Vector3(0f, 0f, -5f), Vector3.zero);
        Light sun = Sun(Vector3.down);
        GameObject cube = Primitive(PrimitiveType.Cube, Vector3.zero);
        LightEvent[] events =
        [
            LightEvent.BeforeShadowMap, LightEvent.BeforeShadowMapPass, LightEvent.AfterShadowMapPass, LightEvent.AfterShadowMap,
            LightEvent.BeforeScreenspaceMask, LightEvent.AfterScreenspaceMask,
        ];
        var buffers = new CommandBuffer[events.Length];
        for (int i = 0; i < events.Length; i++)
        {
            buffers[i] = new CommandBuffer();
            buffers[i].SetGlobalFloat(Last, i + 1f);
            sun.AddCommandBuffer(events[i], buffers[i]);
        }

        Assert.That(sun.commandBufferCount, Is.EqualTo(6));
        for (int i = events.Length - 1; i >= 0; i--)
        {
            Assert.That(LastEvent(), Is.EqualTo(i + 1f), $"{events[i]}");
            Assert.That(sun.GetCommandBuffers(events[i]), Is.EqualTo(new[] { buffers[i] }));
            if (i > 0)
            {
                sun.RemoveCommandBuffer(events[i], buffers[i]);
            }
        }

        cube.SetActive(false);
        Assert.That(LastEvent(), Is.Zero, "nothing casts");
        cube.SetActive(true);
        sun.shadows = LightShadows.None;
        Assert.That(LastEvent(), Is.Zero, "no shadows");
        sun.shadows = LightShadows.Hard;
        sun.RemoveAllCommandBuffers();
        Assert.That(LastEvent(), Is.Zero, "none are left");
    }

    [Test]
    public void TheTargetsThatTheySetDoNotLast()
    {
        Camera camera = Camera(new Vector3(0f, 0f, -5f), Vector3.zero);
        Light sun = Sun(new Vector3(0f, -1f, 1f));
        Primitive(PrimitiveType.Cube, Vector3.zero);
        Frame();
        Color32 before = Picture.OfScreen().At(camera.WorldToScreenPoint(Vector3.zero));
        var other = new RenderTexture(8, 8, 0);
        using var drawing = new CommandBuffer();
        drawing.SetRenderTarget(other);
        drawing.ClearRenderTarget(false, true, Color.red);
        sun.AddCommandBuffer(LightEvent.BeforeShadowMap, drawing);
        sun.AddCommandBuffer(LightEvent.AfterShadowMap, drawing);
        sun.AddCommandBuffer(LightEvent.BeforeScreenspaceMask, drawing);
        Frame();
        Assert.That(Picture.OfScreen().At(camera.WorldToScreenPoint(Vector3.zero)), Is.EqualTo(before));
        Assert.That(IsRed(Picture.Of(other).At(4, 4)), Is.True);
    }

    private static float LastEvent()
    {
        Shader.SetGlobalFloat(Last, 0f);
        Frame();
        return Shader.GetGlobalFloat(Last);
    }
}
