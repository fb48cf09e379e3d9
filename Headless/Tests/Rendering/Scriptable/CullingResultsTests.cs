using NUnit.Framework;
using Unity.Collections;
using UnityEngine;
using UnityEngine.Rendering;

namespace Headless.Tests.Rendering;

public sealed class CullingResultsTests : ScriptableFixture
{
    private const string Lit = """
        Shader "Test/LightIndices"
        {
            SubShader
            {
                Pass
                {
                    HLSLPROGRAM
                    #pragma vertex Vertex
                    #pragma fragment Fragment
                    #include "UnityCG.cginc"
                    float4 unity_LightData;
                    float4 unity_LightIndices[2];
                    float4 unity_RenderingLayer;
                    float4 Vertex(float4 position : POSITION) : SV_POSITION { return UnityObjectToClipPos(position); }
                    float4 Fragment() : SV_Target
                    {
                        bool right = unity_LightData.y == 2 && unity_LightData.z == 1 && unity_LightIndices[0].x == 8 && unity_LightIndices[0].y == 9;
                        return float4(right ? 0 : 1, right && asuint(unity_RenderingLayer.x) == 5 ? 1 : 0, 0, 1);
                    }
                    ENDHLSL
                }
            }
        }
        """;

    private static Light Lamp(string name, Vector3 place, float intensity = 1f)
    {
        var light = new GameObject(name).AddComponent<Light>();
        (light.type, light.range, light.intensity) = (LightType.Point, 4f, intensity);
        light.transform.position = place;
        return light;
    }

    private static void Culled(Action<CullingResults, Camera> check)
    {
        bool checkedOnce = false;
        UseOne((_, camera, culled) =>
        {
            check(culled, camera);
            checkedOnce = true;
        });
        Frame();
        Assert.That(checkedOnce, Is.True);
    }

    [Test]
    public void TheMainLightIsTheFirstThenTheOtherDirectionalOnesThenLampsInView()
    {
        Camera(new Vector3(0f, 0f, -5f), Vector3.zero);
        Light near = Lamp("Near", new Vector3(0f, 0f, -3f));
        Light far = Lamp("Far", new Vector3(0f, 0f, 3f));
        Lamp("Behind", new Vector3(0f, 0f, -20f));
        Light fill = Sun(Vector3.right);
        Light sun = Sun(Vector3.down);
        (fill.intensity, sun.intensity) = (0.5f, 2f);
        Culled((culled, _) => Assert.That(culled.visibleLights.ToArray().Select(l => l.light), Is.EqualTo(new[] { sun, fill, near, far })));
    }

    [Test]
    public void AFinalColorIsLinearTimesIntensityWhereTheSettingsSaySo()
    {
        Camera(new Vector3(0f, 0f, -5f), Vector3.zero);
        Light sun = Sun(Vector3.down);
        (sun.color, sun.intensity) = (new Color(0.5f, 0.5f, 0.5f), 2f);
        Culled((culled, _) => Assert.That(culled.visibleLights[0].finalColor.r, Is.EqualTo(1f).Within(1e-4f), "multiplied first"));
        GraphicsSettings.lightsUseLinearIntensity = true;
        Culled((culled, _) => Assert.That(culled.visibleLights[0].finalColor.r, Is.EqualTo(0.21404f * 2f).Within(1e-3f)));
        (GraphicsSettings.lightsUseColorTemperature, sun.useColorTemperature, sun.colorTemperature) = (true, true, 3000f);
        Color warm = Mathf.CorrelatedColorTemperatureToRGB(3000f);
        Culled((culled, _) => Assert.That(culled.visibleLights[0].finalColor.b, Is.EqualTo(0.21404f * 2f * warm.b).Within(1e-3f)));
    }

    [Test]
    public void AnObjectsLightsAreNumberedByTheMap()
    {
        Camera(new Vector3(0f, 0f, -5f), Vector3.zero);
        Sun(Vector3.down);
        Lamp("Bright", new Vector3(0f, 0f, -2f), 3f);
        Lamp("Dim", new Vector3(0f, 0f, -2f), 1f);
        Lamp("Elsewhere", new Vector3(0f, 30f, 50f));
        Renderer cube = Primitive(PrimitiveType.Cube, Vector3.zero).GetComponent<Renderer>();
        (cube.sharedMaterial, cube.renderingLayerMask) = (MaterialOf(Lit), 5u);
        UseOne((context, camera, culled) =>
        {
            using NativeArray<int> map = culled.GetLightIndexMap(Allocator.Temp);
            Assert.That(map.ToArray(), Is.EqualTo(Enumerable.Range(0, map.Length)));
            NativeArray<int> numbers = map;
            numbers[0] = -1;
            for (int i = 1; i < map.Length; i++)
            {
                numbers[i] = culled.visibleLights[i].light.name == "Bright" ? 8 : 9;
            }

            culled.SetLightIndexMap(numbers);
            DrawingSettings drawing = Drawing(camera, Unlit);
            (drawing.perObjectData, drawing.mainLightIndex) = (PerObjectData.LightData | PerObjectData.LightIndices, 0);
            Draw(context, List(context, culled, drawing));
            Assert.That(culled.lightIndexCount, Is.EqualTo(2));
        });
        Frame();
        Assert.That(IsGreen(Middle()), Is.True);
    }

    [Test]
    public void CasterBoundsHoldWhatShadesTheViewEvenFromOutside()
    {
        Camera(new Vector3(0f, 0f, -5f), Vector3.zero);
        Sun(Vector3.down);
        Culled((culled, _) => Assert.That(culled.GetShadowCasterBounds(0, out Bounds _), Is.False, "no caster"));
        GameObject above = Primitive(PrimitiveType.Cube, new Vector3(0f, 40f, 0f));
        Primitive(PrimitiveType.Cube, new Vector3(0f, -40f, 0f));
        GameObject behind = Primitive(PrimitiveType.Cube, new Vector3(0f, 40f, -30f));
        Culled((culled, _) =>
        {
            Assert.That(culled.GetShadowCasterBounds(0, out Bounds bounds), Is.True);
            Assert.That(bounds, Is.EqualTo(above.GetComponent<Renderer>().bounds), "below and behind the viewer nothing shades what is seen");
        });
        above.GetComponent<Renderer>().shadowCastingMode = ShadowCastingMode.Off;
        behind.GetComponent<Renderer>().shadowCastingMode = ShadowCastingMode.ShadowsOnly;
        Culled((culled, _) => Assert.That(culled.GetShadowCasterBounds(0, out Bounds _), Is.False));
    }

    [TestCase(1)]
    [TestCase(4)]
    public void ACascadesSphereIsTheSmallestRoundItsSlice(int count)
    {
        Camera viewer = Camera(new Vector3(3f, 2f, -5f), Vector3.zero);
        (viewer.farClipPlane, QualitySettings.shadowDistance) = (200f, 50f);
        Sun(new Vector3(0.3f, -1f, 0.2f));
        Primitive(PrimitiveType.Cube, Vector3.zero);
        var ratio = new Vector3(0.1f, 0.3f, 0.6f);
        Culled((culled, camera) =>
        {
            float[] ends = [camera.nearClipPlane, .. count == 1 ? [] : new[] { 5f, 15f, 30f }, 50f];
            for (int i = 0; i < count; i++)
            {
                Assert.That(culled.ComputeDirectionalShadowMatricesAndCullingPrimitives(
                    0, i, count, ratio, 512, 0f, out Matrix4x4 view, out Matrix4x4 projection, out ShadowSplitData split), Is.True);
                Vector3[] corners = [.. Corners(camera, ends[i]), .. Corners(camera, ends[i + 1])];
                float texel = split.cullingSphere.w * 2f / 512f;
                float farthest = corners.Max(c => Vector3.Distance(c, split.cullingSphere));
                Assert.That(farthest, Is.EqualTo(split.cullingSphere.w).Within(texel), $"cascade {i} holds its corners");
                float smallest = Enumerable.Range(0, 2001).Min(s =>
                {
                    Vector3 center = camera.transform.position + (camera.transform.forward * (ends[i + 1] * s / 2000f));
                    return corners.Max(c => Vector3.Distance(c, center));
                });
                Assert.That(split.cullingSphere.w, Is.EqualTo(smallest).Within(0.002f * smallest), $"cascade {i} is no larger than it must be");
                foreach (Vector3 side in new[] { Vector3.right, Vector3.up, Vector3.forward })
                {
                    Vector3 clip = (projection * view).MultiplyPoint((Vector3)split.cullingSphere + (side * split.cullingSphere.w));
                    Assert.That(Mathf.Max(Mathf.Abs(clip.x), Mathf.Abs(clip.y), Mathf.Abs(clip.z)), Is.LessThan(1.001f));
                }
            }
        });
    }

    [Test]
    public void CascadesMoveByWholeTexels()
    {
        Camera viewer = Camera(new Vector3(0f, 0f, -5f), Vector3.zero);
        QualitySettings.shadowDistance = 30f;
        Sun(new Vector3(0.3f, -1f, 0.2f));
        Primitive(PrimitiveType.Cube, Vector3.zero);
        var places = new List<Vector3>();
        for (int i = 0; i < 5; i++)
        {
            viewer.transform.position += new Vector3(0.0137f, 0.0071f, 0.0213f);
            Culled((culled, _) =>
            {
                culled.ComputeDirectionalShadowMatricesAndCullingPrimitives(0, 0, 1, Vector3.one, 256, 0f, out Matrix4x4 view, out Matrix4x4 projection, out ShadowSplitData _);
                places.Add((projection * view).MultiplyPoint(new Vector3(0.123f, 0.456f, 0.789f)) * 128f);
            });
        }

        foreach (Vector3 place in places)
        {
            Vector3 moved = place - places[0];
            Assert.That(Mathf.Abs(moved.x - Mathf.Round(moved.x)), Is.LessThan(0.02f));
            Assert.That(Mathf.Abs(moved.y - Mathf.Round(moved.y)), Is.LessThan(0.02f));
        }

        Assert.That(places.Select(p => Mathf.Round(p.x)).Distinct().Count(), Is.LessThanOrEqualTo(5));
    }

    [Test]
    public void SpotAndPointLightsSeeFromTheirPlace()
    {
        Camera(new Vector3(0f, 0f, -5f), Vector3.zero);
        Light spot = Lamp("Spot", new Vector3(0f, 2f, 0f));
        (spot.type, spot.spotAngle, spot.shadows) = (LightType.Spot, 60f, LightShadows.Hard);
        spot.transform.rotation = Quaternion.LookRotation(Vector3.down, Vector3.forward);
        Primitive(PrimitiveType.Cube, Vector3.zero);
        Culled((culled, _) =>
        {
            Assert.That(culled.ComputeSpotShadowMatricesAndCullingPrimitives(0, out Matrix4x4 view, out Matrix4x4 projection, out ShadowSplitData _), Is.True);
            Vector3 rim = new(Mathf.Tan(30f * Mathf.Deg2Rad), 1f, 0f);
            Vector3 clip = (projection * view).MultiplyPoint(rim);
            Assert.That((Mathf.Abs(clip.x), clip.y), Is.EqualTo((1f, 0f)).Using<(float, float)>((a, b) =>
                Mathf.Abs(a.Item1 - b.Item1) + Mathf.Abs(a.Item2 - b.Item2) < 1e-3f ? 0 : 1), "the edge of the cone");
        });
        spot.type = LightType.Point;
        Culled((culled, _) =>
        {
            culled.ComputePointShadowMatricesAndCullingPrimitives(0, CubemapFace.PositiveX, 0f, out Matrix4x4 view, out Matrix4x4 projection, out ShadowSplitData _);
            Vector3 clip = (projection * view).MultiplyPoint(new Vector3(2f, 3f, 1f));
            Assert.That(clip.x, Is.EqualTo(-0.5f).Within(1e-3f), "+z is to the left of +x");
            Assert.That(clip.y, Is.EqualTo(-0.5f).Within(1e-3f), "upside down");
        });
    }

    private static IEnumerable<Vector3> Corners(Camera camera, float distance) =>
        from x in new[] { 0f, 1f } from y in new[] { 0f, 1f } select camera.ViewportToWorldPoint(new Vector3(x, y, distance));
}
