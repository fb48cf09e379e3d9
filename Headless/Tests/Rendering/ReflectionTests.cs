using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;

namespace Headless.Tests.Rendering;

public sealed class ReflectionTests : SceneFixture
{
    // What an object would mirror in one direction.
    private const string Probe = """
        Shader "Test/Probe"
        {
            SubShader
            {
                Pass
                {
                    Cull Off
                    HLSLPROGRAM
                    #pragma vertex Vertex
                    #pragma fragment Fragment
                    #include "UnityCG.cginc"
                    float4 _Direction;
                    float4 Vertex(float4 position : POSITION) : SV_POSITION { return UnityObjectToClipPos(position); }
                    float4 Fragment() : SV_Target
                    {
                        half4 data = UNITY_SAMPLE_TEXCUBE_LOD(unity_SpecCube0, _Direction.xyz, _Direction.w);
                        return float4(DecodeHDR(data, unity_SpecCube0_HDR), 1);
                    }
                    ENDHLSL
                }
            }
        }
        """;

    // Where one looks as red and green, blue where the sun stands.
    private const string DirectionSky = """
        Shader "Test/DirectionSky"
        {
            SubShader
            {
                Tags { "Queue" = "Background" "PreviewType" = "Skybox" }
                Pass
                {
                    Cull Off
                    ZWrite Off
                    HLSLPROGRAM
                    #pragma vertex Vertex
                    #pragma fragment Fragment
                    #include "UnityCG.cginc"
                    struct Varyings { float4 place : SV_POSITION; float3 direction : TEXCOORD0; };
                    Varyings Vertex(float4 position : POSITION)
                    {
                        Varyings o;
                        o.place = UnityObjectToClipPos(position);
                        o.direction = mul((float3x3)unity_ObjectToWorld, position.xyz);
                        return o;
                    }
                    float4 Fragment(Varyings i) : SV_Target
                    {
                        float3 direction = normalize(i.direction);
                        return float4(direction.xy * 0.5 + 0.5, dot(direction, _WorldSpaceLightPos0.xyz) > 0.999, 1);
                    }
                    ENDHLSL
                }
            }
        }
        """;

    private static readonly Vector3[] Directions = [Vector3.right, Vector3.left, Vector3.up, Vector3.down, Vector3.forward, Vector3.back];
    private static readonly Color[] Colors = [Color.red, Color.green, Color.blue, Color.white, new(1f, 1f, 0f, 1f), new(0f, 1f, 1f, 1f)];

    [Test]
    public void FacesLieAsInDirect3D([Values] bool mipMaps)
    {
        Cubemap cube = Faces(Colors, mipMaps);
        cube.SetPixel(CubemapFace.PositiveZ, 0, 0, Color.black);
        cube.SetPixel(CubemapFace.PositiveX, 0, 0, Color.black);
        cube.SetPixel(CubemapFace.PositiveY, 0, 0, Color.black);
        cube.Apply();
        Mirror(cube);
        for (int face = 0; face < 6; face++)
        {
            Assert.That(Seen(Directions[face]), Is.EqualTo((Color32)Colors[face]), $"{(CubemapFace)face}");
        }

        // The first texel of the first row: top left seen from inside, where forward is above the face that looks up.
        Assert.That(IsBlack(Seen(new Vector3(-0.9f, 0.9f, 1f))), Is.True, "+Z");
        Assert.That(IsBlack(Seen(new Vector3(1f, 0.9f, 0.9f))), Is.True, "+X");
        Assert.That(IsBlack(Seen(new Vector3(-0.9f, 1f, -0.9f))), Is.True, "+Y");
        if (mipMaps)
        {
            Color average = Seen(Vector3.forward, 3f);
            Assert.That(average.linear.r, Is.EqualTo(63f / 64f).Within(0.01f), "mean of 64 texels");
        }
    }

    [Test]
    public void WithoutProbesTheSkyIsMirrored()
    {
        Camera camera = Camera(new Vector3(0f, 0f, -5f), Vector3.zero);
        camera.clearFlags = CameraClearFlags.Skybox;
        foreach (Vector3 direction in (Vector3[])[new(0f, 0.5f, 1f), new(0f, -0.5f, 1f), new(1f, 0.1f, 0.3f), new(-1f, -0.1f, -2f), new(0.1f, 1f, 0.1f), new(0f, -1f, 0.05f)])
        {
            camera.transform.rotation = Quaternion.LookRotation(direction);
            Frame();
            Color32 sky = Picture.OfScreen().At(64, 48);
            camera.transform.rotation = Quaternion.identity;
            Color32 mirrored = Seen(direction);
            int difference = new[] { mirrored.r - sky.r, mirrored.g - sky.g, mirrored.b - sky.b }.Max(Math.Abs);
            Assert.That(difference, Is.LessThanOrEqualTo(4), $"{direction}: {mirrored}, sky {sky}");
        }

        Assert.That(ReflectionProbe.defaultTexture.dimension, Is.EqualTo(TextureDimension.Cube));
        Assert.That(ReflectionProbe.defaultTexture.mipmapCount, Is.EqualTo(8));

        // Rougher levels lie between the colors of the sharp one.
        Color rough = Seen(Vector3.up, 6f);
        Assert.That(rough.b, Is.GreaterThan(rough.r));
        RenderSettings.reflectionIntensity = 0.5f;
        Color32 half = Seen(Vector3.up);
        RenderSettings.reflectionIntensity = 1f;
        Assert.That(((Color)half).linear.b, Is.EqualTo(((Color)Seen(Vector3.up)).linear.b * 0.5f).Within(0.01f));
    }

    [Test]
    public void ASkyboxMaterialIsDrawnBehindEverythingAndMirrored()
    {
        Sun(new Vector3(0f, -0.6f, -0.8f));
        RenderSettings.skybox = MaterialOf(DirectionSky);
        Camera camera = Camera(new Vector3(2f, 1f, -4f), Vector3.zero);
        camera.clearFlags = CameraClearFlags.Skybox;
        camera.farClipPlane = 6f;
        var sun = new Vector3(0f, 0.6f, 0.8f);
        foreach (Vector3 direction in (Vector3[])[new(0f, 0.5f, 1f), new(0.4f, -0.5f, 1f), new(1f, 0.1f, 0.3f), new(-1f, -0.1f, -2f), new(0.1f, 1f, 0.1f), new(0f, -1f, 0.05f), sun])
        {
            Vector3 d = direction.normalized;
            var expected = new Color((d.x * 0.5f) + 0.5f, (d.y * 0.5f) + 0.5f, Vector3.Dot(d, sun) > 0.999f ? 1f : 0f).gamma;
            camera.transform.rotation = Quaternion.LookRotation(d);
            Frame();
            AssertNear((Color)Picture.OfScreen().At(64, 48), expected, $"seen at {direction}");
            camera.transform.rotation = Quaternion.LookRotation(-camera.transform.position);
            AssertNear((Color)Seen(d), expected, $"mirrored at {direction}");
        }

        // Whatever stands in front hides it, near the far plane too.
        camera.transform.SetPositionAndRotation(new Vector3(0f, 0f, -5.9f), Quaternion.identity);
        GameObject quad = GameObject.CreatePrimitive(PrimitiveType.Quad);
        quad.GetComponent<Renderer>().sharedMaterial = new Material(Shader.Find("Unlit/Color")) { color = Color.red };
        Frame();
        Assert.That(IsRed(Picture.OfScreen().At(64, 48)), Is.True, "in front of the sky");
    }

    [Test]
    public void WithoutASkyboxTheBackgroundColorIsSeenAndBlackIsMirrored()
    {
        Camera camera = Camera(new Vector3(0f, 0f, -5f), Vector3.zero);
        camera.clearFlags = CameraClearFlags.Skybox;
        camera.backgroundColor = Color.green;
        RenderSettings.skybox = null;
        Frame();
        Assert.That(IsGreen(Picture.OfScreen().At(64, 48)), Is.True);
        Assert.That(IsBlack(Seen(Vector3.up)), Is.True);
    }

    [Test]
    public void AnOwnCubemapInTheSkysPlace()
    {
        Mirror(Faces(Colors, false));
        Assert.That(Seen(Vector3.left), Is.EqualTo((Color32)Color.green));
        Assert.That(ReflectionProbe.defaultTexture, Is.SameAs(RenderSettings.customReflectionTexture));
        RenderSettings.defaultReflectionMode = DefaultReflectionMode.Skybox;
        Assert.That(Seen(Vector3.left), Is.Not.EqualTo((Color32)Color.green));
    }

    [Test]
    public void ObjectsMirrorTheMostImportantProbeThatTouchesThem()
    {
        Mirror(Faces([Color.black, Color.black, Color.black, Color.black, Color.black, Color.black], false));
        ReflectionProbe probe = AddProbe(Color.green, Vector3.zero, 10f);
        ReflectionProbe corner = AddProbe(Color.red, Vector3.zero, 1f);
        Assert.That(IsGreen(Seen(Vector3.up)), Is.True, "of equals, the one that shares more");
        corner.importance = 2;
        Assert.That(IsRed(Seen(Vector3.up)), Is.True, "the more important one");
        corner.transform.position = new Vector3(0f, 0f, 50f);
        Assert.That(IsGreen(Seen(Vector3.up)), Is.True, "only where its box is");
        Assert.That(IsBlack(Seen(Vector3.up, 0f, ReflectionProbeUsage.Off)), Is.True, "without probes");
        probe.intensity = 0.25f;
        Assert.That(((Color)Seen(Vector3.up)).linear.g, Is.EqualTo(0.25f).Within(0.01f));
        probe.enabled = false;
        Assert.That(IsBlack(Seen(Vector3.up)), Is.True);
    }

    [Test]
    public void ProbesAreNotBakedAndSaySo()
    {
        var probe = new GameObject("Hall").AddComponent<ReflectionProbe>();
        probe.transform.position = new Vector3(1f, 2f, 3f);
        probe.center = Vector3.up;
        Assert.That(probe.bounds, Is.EqualTo(new Bounds(new Vector3(1f, 3f, 3f), new Vector3(10f, 10f, 10f))));
        Assert.That(probe.texture, Is.Null);
        Assert.That(probe.RenderProbe(), Is.EqualTo(-1));
        Assert.That(Warnings, Has.Some.Contains("Hall"));
    }

    [Test]
    public void ARealtimeProbeMirrorsTheSkyItself()
    {
        RenderSettings.skybox = MaterialOf(DirectionSky);
        Mirror(Faces([Color.black, Color.black, Color.black, Color.black, Color.black, Color.black], false));
        ReflectionProbe probe = AddProbe(Color.green, Vector3.zero, 10f);
        (probe.mode, probe.cullingMask, probe.resolution) = (ReflectionProbeMode.Realtime, 0, 64);
        Vector3 d = new Vector3(0.4f, -0.5f, 1f).normalized;
        AssertNear((Color)Seen(d), new Color((d.x * 0.5f) + 0.5f, (d.y * 0.5f) + 0.5f, 0f).gamma, "on awake");
        Texture first = probe.texture!;
        Frame();
        Assert.That(probe.texture, Is.SameAs(first));
        Assert.That(first.width, Is.EqualTo(64));
        Assert.That(Warnings, Is.Empty);
    }

    [Test]
    public void ARealtimeProbeDrawsWhenItIsToldTo()
    {
        ReflectionProbe probe = AddProbe(Color.green, Vector3.zero, 10f);
        (probe.mode, probe.refreshMode, probe.clearFlags) = (ReflectionProbeMode.Realtime, ReflectionProbeRefreshMode.ViaScripting, ReflectionProbeClearFlags.SolidColor);
        probe.backgroundColor = Color.red;
        Assert.That(probe.texture, Is.Null);
        Assert.That(probe.RenderProbe(), Is.GreaterThanOrEqualTo(0));
        Assert.That(IsRed(Seen(Vector3.up)), Is.True);
        Assert.That(Warnings, Has.Some.Contains("not the things of its culling mask"));
        probe.enabled = false;
        QualitySettings.realtimeReflectionProbes = false;
        var off = new GameObject("Off").AddComponent<ReflectionProbe>();
        off.mode = ReflectionProbeMode.Realtime;
        Assert.That(off.texture, Is.Null, "the quality level has no realtime probes");
        QualitySettings.realtimeReflectionProbes = true;
    }

    private static void AssertNear(Color seen, Color expected, string what)
    {
        for (int c = 0; c < 3; c++)
        {
            Assert.That(seen[c], Is.EqualTo(expected[c]).Within(0.02f), $"{what}: {seen}, not {expected}");
        }
    }

    private static Cubemap Faces(Color[] colors, bool mipMaps)
    {
        var cube = new Cubemap(8, TextureFormat.RGBA32, mipMaps) { filterMode = FilterMode.Point };
        for (int face = 0; face < 6; face++)
        {
            cube.SetPixels([.. Enumerable.Repeat(colors[face], 64)], (CubemapFace)face);
        }

        cube.Apply();
        return cube;
    }

    private static void Mirror(Cubemap cube)
    {
        RenderSettings.defaultReflectionMode = DefaultReflectionMode.Custom;
        RenderSettings.customReflectionTexture = cube;
    }

    private static ReflectionProbe AddProbe(Color color, Vector3 position, float size)
    {
        var probe = new GameObject("Probe").AddComponent<ReflectionProbe>();
        probe.transform.position = position;
        probe.size = Vector3.one * size;
        probe.mode = ReflectionProbeMode.Custom;
        probe.customBakedTexture = Faces([color, color, color, color, color, color], false);
        return probe;
    }

    /// <summary>What a cube of one metre at the origin mirrors in a direction.</summary>
    private Color32 Seen(Vector3 direction, float level = 0f, ReflectionProbeUsage usage = ReflectionProbeUsage.BlendProbes)
    {
        if (UnityEngine.Camera.main == null)
        {
            Camera(new Vector3(0f, 0f, -5f), Vector3.zero);
        }

        GameObject cube = GameObject.CreatePrimitive(PrimitiveType.Cube);
        Material material = MaterialOf(Probe);
        Vector3 d = direction.normalized;
        material.SetVector("_Direction", new Vector4(d.x, d.y, d.z, level));
        cube.GetComponent<Renderer>().sharedMaterial = material;
        cube.GetComponent<Renderer>().reflectionProbeUsage = usage;
        Frame();
        UnityEngine.Object.DestroyImmediate(cube);
        return Picture.OfScreen().At(64, 48);
    }
}
