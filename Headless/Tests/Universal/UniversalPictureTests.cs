using Headless.Engine;
using Headless.Tests.Rendering;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

namespace Headless.Tests.Universal;

/// <summary>Pictures of the pipeline against what geometry says: shadows, copies of the scene, sizes, stacks.</summary>
public sealed class UniversalPictureTests : UniversalFixture
{
    private const string Shows = "Texture2D<float4> _CameraOpaqueTexture; Texture2D<float> _CameraDepthTexture; SamplerState sampler_PointClamp;";

    private static readonly Color Blue = new(0f, 0f, 1f);

    // A block in the sun at 45 degrees over a floor: the shadow lies beside it, as long as the block is high.
    [TestCase(1)]
    [TestCase(2)]
    [TestCase(3)]
    [TestCase(4)]
    public void AShadowLiesWhereTheLightPutsIt(int cascades)
    {
        Asset.shadowCascadeCount = cascades;
        Camera camera = Terrace();
        Frame(2);
        Picture seen = Picture.OfScreen().Keep($"shadow-{cascades}");
        float lit = seen.Brightness(camera.WorldToScreenPoint(new Vector3(-1.5f, 0f, 0f)));
        float shaded = seen.Brightness(camera.WorldToScreenPoint(new Vector3(1f, 0f, 0f)));
        float behind = seen.Brightness(camera.WorldToScreenPoint(new Vector3(2f, 0f, 0f)));
        Assert.That(shaded, Is.LessThan(0.6f * lit));
        Assert.That(behind, Is.EqualTo(lit).Within(0.02f));
        Assert.That(EdgeOfShadow(seen, camera), Is.EqualTo(1.5f).Within(0.06f), "the block is 1 m high, and its edge stands at 0.5 m");
    }

    // From near to beyond the shadow distance, floors that nothing shades are as bright with shadows as without.
    [TestCase(1)]
    [TestCase(4)]
    public void AFloorDoesNotShadeItself(int cascades)
    {
        Asset.shadowCascadeCount = cascades;
        Camera camera = Camera(new Vector3(0f, 3f, -4f), new Vector3(0f, 0f, 8f));
        Light sun = Sun(new Vector3(1f, -0.35f, 0.4f));
        GameObject floor = Lit(PrimitiveType.Cube, new Vector3(0f, -0.5f, 40f), Color.white);
        floor.transform.localScale = new Vector3(60f, 1f, 120f);
        Lit(PrimitiveType.Cube, new Vector3(40f, 5f, 0f), Color.white);
        Frame(2);
        Picture shadowed = Picture.OfScreen();
        sun.shadows = LightShadows.None;
        Frame(2);
        Picture plain = Picture.OfScreen();
        for (int z = -1; z < 60; z += 3)
        {
            Vector3 at = camera.WorldToScreenPoint(new Vector3(0f, 0f, z));
            if (at.y < 0f)
            {
                continue;
            }

            Assert.That(shadowed.Brightness(at), Is.EqualTo(plain.Brightness(at)).Within(0.01f), $"{z} m ahead");
        }
    }

    [Test]
    public void SpheresOfCascadesHoldTheirSlices()
    {
        Asset.shadowCascadeCount = 4;
        Camera camera = Terrace();
        string[] names = [.. Enumerable.Range(0, 4).Select(i => $"_CascadeShadowSplitSpheres{i}")];
        var probe = new FactProbe(RenderPassEvent.BeforeRenderingOpaques, 0, MaterialOf, string.Concat(names.Select(n => $"float4 {n};")), names);
        using (Enqueue(probe))
        {
            Frame(2);
        }

        Vector4[] spheres = probe.Read();
        float distance = Mathf.Min(Asset.shadowDistance, camera.farClipPlane);
        float[] ends = [0f, Asset.cascade4Split.x, Asset.cascade4Split.y, Asset.cascade4Split.z, 1f];
        for (int i = 0; i < 4; i++)
        {
            float near = Mathf.Max(camera.nearClipPlane, ends[i] * distance);
            float far = ends[i + 1] * distance;
            float least = 0f;
            for (int corner = 0; corner < 8; corner++)
            {
                Vector3 at = camera.ViewportToWorldPoint(new Vector3(corner & 1, (corner >> 1) & 1, (corner & 4) == 0 ? near : far));
                Assert.That(Vector3.Distance(at, spheres[i]), Is.LessThan(spheres[i].w * 1.01f), $"corner {corner} of cascade {i}");
                least = Mathf.Max(least, Vector3.Distance(at, camera.transform.position + (camera.transform.forward * far)));
            }

            Assert.That(spheres[i].w, Is.LessThan(1.5f * Mathf.Max(least, (far - near) * 0.5f)), $"cascade {i} wastes none of its map");
        }
    }

    [Test]
    public void WithoutACasterInViewAllIsLit()
    {
        Camera camera = Camera(new Vector3(0f, 3f, -5f), Vector3.zero);
        Sun(new Vector3(1f, -1f, 0f)).shadowStrength = 0.9f;
        GameObject floor = Lit(PrimitiveType.Cube, new Vector3(0f, -0.5f, 0f), Color.white);
        floor.transform.localScale = new Vector3(10f, 1f, 10f);
        floor.GetComponent<Renderer>().shadowCastingMode = ShadowCastingMode.Off;
        Frame(2);
        float alone = Picture.OfScreen().Brightness(camera.WorldToScreenPoint(Vector3.zero));
        Asset.shadowDistance = 0f;
        Frame(2);
        Assert.That(Picture.OfScreen().Brightness(camera.WorldToScreenPoint(Vector3.zero)), Is.EqualTo(alone).Within(0.005f));
        Assert.That(alone, Is.GreaterThan(0.5f));
    }

    // The upper half is sky, the lower a floor; the copy has both where the picture has them, at each size.
    [TestCase(Downsampling.None, 1)]
    [TestCase(Downsampling._2xBilinear, 2)]
    [TestCase(Downsampling._4xBilinear, 4)]
    [TestCase(Downsampling._4xBox, 4)]
    public void TheOpaqueTextureHasTheSkyAndTheScene(Downsampling downsampling, int divisor)
    {
        Set("m_OpaqueDownsampling", downsampling);
        Horizon();
        var probe = new FactProbe(
            RenderPassEvent.BeforeRenderingTransparents, ScriptableRenderPassInput.Color, MaterialOf,
            Shows + "float4 Size() { float2 s; _CameraOpaqueTexture.GetDimensions(s.x, s.y); return float4(s, 0, 0); }",
            ["_CameraOpaqueTexture.SampleLevel(sampler_PointClamp, float2(0.5, 0.8), 0)", "_CameraOpaqueTexture.SampleLevel(sampler_PointClamp, float2(0.5, 0.2), 0)", "Size()"]);
        using (Enqueue(probe))
        {
            Frame(2);
        }

        Vector4[] seen = probe.Read();
        Assert.That(new[] { seen[2].x, seen[2].y }, Is.EqualTo(new[] { 128f / divisor, 96f / divisor }));
        Picture picture = Picture.OfScreen();
        Assert.That(seen[1].y, Is.GreaterThan(0.9f), "the floor is below");
        Assert.That(seen[0].z, Is.GreaterThan(0.2f), "the sky is above");
        Assert.That(Mathf.LinearToGammaSpace(seen[0].z) * 255f, Is.EqualTo(picture.At(64, 76).b).Within(4f), "as the picture has it");
    }

    // A wall 4 m ahead: by a prepass, by a copy and by priming, at each event that may read it.
    [TestCase(1, DepthPrimingMode.Disabled, RenderPassEvent.BeforeRenderingTransparents)]
    [TestCase(1, DepthPrimingMode.Disabled, RenderPassEvent.BeforeRenderingOpaques)]
    [TestCase(1, DepthPrimingMode.Forced, RenderPassEvent.BeforeRenderingTransparents)]
    [TestCase(1, DepthPrimingMode.Forced, RenderPassEvent.BeforeRenderingOpaques)]
    [TestCase(4, DepthPrimingMode.Disabled, RenderPassEvent.BeforeRenderingTransparents)]
    public void TheDepthTextureHasTheWall(int samples, DepthPrimingMode priming, RenderPassEvent at)
    {
        Asset.msaaSampleCount = samples;
        Renderer.depthPrimingMode = priming;
        Camera camera = Camera(Vector3.zero, Vector3.forward);
        GameObject wall = Lit(PrimitiveType.Cube, new Vector3(0f, 0f, 4.5f), Color.red);
        wall.transform.localScale = new Vector3(20f, 2f, 1f);
        var probe = new FactProbe(
            at, ScriptableRenderPassInput.Depth, MaterialOf, Shows,
            ["_CameraDepthTexture.SampleLevel(sampler_PointClamp, float2(0.5, 0.5), 0)", "_CameraDepthTexture.SampleLevel(sampler_PointClamp, float2(0.5, 0.95), 0)"]);
        using (Enqueue(probe))
        {
            Frame(2);
        }

        Vector4[] seen = probe.Read();
        float expected = camera.nearClipPlane * (camera.farClipPlane - 4f) / (4f * (camera.farClipPlane - camera.nearClipPlane));
        Assert.That(seen[0].x, Is.EqualTo(expected).Within(1e-5f));
        Assert.That(seen[1].x, Is.EqualTo(0f), "nothing above the wall");
        Assert.That(Picture.OfScreen().At(64, 48).r, Is.GreaterThan(10), "and it is drawn");
    }

    // The picture's parts keep their places: 4 quarters of 4 colours, through textures or not, scaled or not, multisampled or not.
    [TestCase(true, 1f, 1)]
    [TestCase(false, 1f, 1)]
    [TestCase(true, 0.5f, 1)]
    [TestCase(true, 2f, 1)]
    [TestCase(true, 1f, 4)]
    [TestCase(false, 1f, 4)]
    public void ThePictureStandsUpright(bool hdr, float scale, int samples)
    {
        (Asset.supportsHDR, Asset.renderScale, Asset.msaaSampleCount) = (hdr, scale, samples);
        Quarters();
        Frame(2);
        AssertQuarters(Picture.OfScreen());
    }

    [TestCase(false)]
    [TestCase(true)]
    public void ThePictureStandsUprightInATexture(bool hdr)
    {
        Asset.supportsHDR = hdr;
        Camera camera = Quarters();
        var target = new RenderTexture(128, 96, 24);
        camera.targetTexture = target;
        Frame(2);
        AssertQuarters(Picture.Of(target));
    }

    [Test]
    public void TwoCamerasShareTheScreen()
    {
        Camera left = Quarters();
        left.rect = new Rect(0f, 0f, 0.5f, 1f);
        Camera right = Camera(new Vector3(100f, 0f, 0f), new Vector3(100f, 0f, 1f));
        right.rect = new Rect(0.5f, 0f, 0.5f, 1f);
        right.backgroundColor = Blue;
        Frame(2);
        Picture seen = Picture.OfScreen();
        Assert.That(IsRed(seen.At(16, 72)) && IsGreen(seen.At(48, 72)), "the left one's quarters");
        Assert.That(seen.At(96, 48).b, Is.GreaterThan(250));
        Assert.That(seen.At(66, 90).b, Is.GreaterThan(250));
    }

    [Test]
    public void AnOverlayCameraDrawsOverItsBase()
    {
        Camera under = Quarters();
        Camera over = Camera(new Vector3(0f, 0f, -50f), Vector3.zero);
        over.GetUniversalAdditionalCameraData().renderType = CameraRenderType.Overlay;
        over.cullingMask = 1 << 5;
        under.cullingMask &= ~(1 << 5);
        under.GetUniversalAdditionalCameraData().cameraStack!.Add(over);
        GameObject mark = Flat(PrimitiveType.Cube, new Vector3(0f, 0f, -45f), Color.white);
        mark.layer = 5;
        Frame(2);
        Picture seen = Picture.OfScreen();
        Assert.That(seen.At(64, 48).b, Is.GreaterThan(250), "the mark is white");
        Assert.That(IsRed(seen.At(4, 92)) && IsGreen(seen.At(124, 92)), "the base's corners");
    }

    [Test]
    public void ASceneViewCameraDrawsAndHasNoScale()
    {
        Asset.renderScale = 0.5f;
        Camera camera = Quarters();
        camera.cameraType = CameraType.SceneView;
        var probe = new FactProbe(RenderPassEvent.BeforeRenderingOpaques, 0, MaterialOf, "float4 _ScaledScreenParams;", ["_ScaledScreenParams"]);
        using (Enqueue(probe))
        {
            Frame(2);
        }

        Assert.That(probe.Read()[0].x, Is.EqualTo(128f));
        AssertQuarters(Picture.OfScreen());
    }

    [Test]
    public void AnOrthographicViewHasItsShadowInPlace()
    {
        Camera camera = Terrace();
        (camera.orthographic, camera.orthographicSize) = (true, 2.5f);
        Frame(2);
        Assert.That(EdgeOfShadow(Picture.OfScreen().Keep("orthographic"), camera), Is.EqualTo(1.5f).Within(0.08f));
    }

    // Six lamps over a floor, in Forward with all six an object and in Forward+: the same light.
    [Test]
    public void ClustersLightAsListsDo([Values(1f, 0.5f)] float scale, [Values] bool orthographic)
    {
        Asset.maxAdditionalLightsCount = 8;
        Asset.renderScale = scale;
        Camera camera = Camera(new Vector3(0f, 4f, -5f), new Vector3(0f, 0f, 0.5f));
        (camera.orthographic, camera.orthographicSize) = (orthographic, 3f);
        GameObject floor = Lit(PrimitiveType.Cube, new Vector3(0f, -0.5f, 0f), Color.white);
        floor.transform.localScale = new Vector3(12f, 1f, 12f);
        for (int i = 0; i < 6; i++)
        {
            var lamp = new GameObject($"Lamp {i}").AddComponent<Light>();
            (lamp.type, lamp.range, lamp.intensity) = (i % 2 == 0 ? LightType.Point : LightType.Spot, 2f + (0.4f * i), 2f);
            lamp.color = Color.HSVToRGB(i / 6f, 0.8f, 1f);
            lamp.transform.position = new Vector3((2f * (i % 3)) - 2f, 1f, (2.5f * (i / 3)) - 1.5f);
            lamp.transform.rotation = Quaternion.LookRotation(Vector3.down);
        }

        Frame(2);
        Picture lists = Picture.OfScreen().Keep($"lists-{scale}-{orthographic}");
        Renderer.renderingMode = RenderingMode.ForwardPlus;
        Frame(2);
        Picture clusters = Picture.OfScreen().Keep($"clusters-{scale}-{orthographic}");
        int coloured = 0;
        for (int y = 0; y < clusters.Height; y++)
        {
            for (int x = 0; x < clusters.Width; x++)
            {
                (Color32 a, Color32 b) = (lists.At(x, y), clusters.At(x, y));
                Assert.That(Math.Abs(a.r - b.r) + Math.Abs(a.g - b.g) + Math.Abs(a.b - b.b), Is.LessThan(4), $"pixel {x}, {y}: {a} {b}");
                coloured += Math.Max(a.r, Math.Max(a.g, a.b)) - Math.Min(a.r, Math.Min(a.g, a.b)) > 60 ? 1 : 0;
            }
        }

        Assert.That(coloured, Is.GreaterThan(1000));
    }

    [TestCase(LightType.Spot)]
    [TestCase(LightType.Point)]
    public void ALampsShadowLiesBehindWhatIsInItsWay(LightType type)
    {
        Set("m_AdditionalLightShadowsSupported", true);
        Camera camera = Camera(new Vector3(0f, 5f, -4f), Vector3.zero);
        GameObject floor = Lit(PrimitiveType.Cube, new Vector3(0f, -0.5f, 0f), Color.white);
        floor.transform.localScale = new Vector3(12f, 1f, 12f);
        Lit(PrimitiveType.Cube, new Vector3(0f, 0.5f, 0f), Color.white);
        var lamp = new GameObject("Lamp").AddComponent<Light>();
        (lamp.type, lamp.range, lamp.intensity, lamp.spotAngle, lamp.shadows) = (type, 12f, 30f, 100f, LightShadows.Hard);
        lamp.transform.position = new Vector3(-2f, 2f, 0f);
        lamp.transform.rotation = Quaternion.LookRotation(new Vector3(2f, -2f, 0f));
        Frame(2);
        Picture seen = Picture.OfScreen().Keep($"lamp-{type}");
        float shaded = seen.Brightness(camera.WorldToScreenPoint(new Vector3(1.2f, 0f, 0f)));
        float lit = seen.Brightness(camera.WorldToScreenPoint(new Vector3(1.2f, 0f, 1.6f)));
        Assert.That(shaded, Is.LessThan(0.6f * lit));
    }

    /// <summary>A block 1 m wide and high on a floor, in the sun from the left at 45 degrees, without ambient light.</summary>
    private static Camera Terrace()
    {
        RenderSettings.ambientMode = AmbientMode.Flat;
        RenderSettings.ambientLight = new Color(0.2f, 0.2f, 0.2f);
        Camera camera = Camera(new Vector3(0.5f, 4f, -3f), new Vector3(0.5f, 0f, 0f));
        Sun(new Vector3(1f, -1f, 0f)).shadows = LightShadows.Hard;
        GameObject floor = Lit(PrimitiveType.Cube, new Vector3(0f, -0.5f, 0f), Color.white);
        floor.transform.localScale = new Vector3(12f, 1f, 12f);
        Lit(PrimitiveType.Cube, new Vector3(0f, 0.5f, 0f), Color.white);
        return camera;
    }

    /// <summary>Where the floor turns from shadow to light along x, in metres.</summary>
    private static float EdgeOfShadow(Picture seen, Camera camera)
    {
        float dark = seen.Brightness(camera.WorldToScreenPoint(new Vector3(1f, 0f, 0f)));
        float lit = seen.Brightness(camera.WorldToScreenPoint(new Vector3(2f, 0f, 0f)));
        for (float x = 1f; x < 2f; x += 0.01f)
        {
            if (seen.Brightness(camera.WorldToScreenPoint(new Vector3(x, 0f, 0f))) > 0.5f * (dark + lit))
            {
                return x;
            }
        }

        return float.NaN;
    }

    /// <summary>Red upper left, green upper right, blue lower left, white lower right.</summary>
    private Camera Quarters()
    {
        Camera camera = Camera(new Vector3(0f, 0f, -10f), Vector3.zero);
        Flat(PrimitiveType.Cube, new Vector3(-10f, 10f, 0f), Color.red).transform.localScale = Vector3.one * 19.99f;
        Flat(PrimitiveType.Cube, new Vector3(10f, 10f, 0f), Color.green).transform.localScale = Vector3.one * 19.99f;
        Flat(PrimitiveType.Cube, new Vector3(-10f, -10f, 0f), Blue).transform.localScale = Vector3.one * 19.99f;
        Flat(PrimitiveType.Cube, new Vector3(10f, -10f, 0f), Color.white).transform.localScale = Vector3.one * 19.99f;
        camera.transform.position = new Vector3(0f, 0f, -30f);
        return camera;
    }

    private static void AssertQuarters(Picture seen)
    {
        Assert.That(IsRed(seen.At(32, 72)), $"upper left {seen.At(32, 72)}");
        Assert.That(IsGreen(seen.At(96, 72)), $"upper right {seen.At(96, 72)}");
        Assert.That(seen.At(32, 24).b, Is.GreaterThan(250), "lower left");
        Assert.That(seen.At(32, 24).r, Is.LessThan(5), "lower left");
        Assert.That(seen.At(96, 24).r + seen.At(96, 24).b, Is.GreaterThan(500), "lower right");
    }

    /// <summary>A green floor that fills the lower half, under the sky, on a red background.</summary>
    private void Horizon()
    {
        Camera camera = Camera(new Vector3(0f, 1f, 0f), new Vector3(0f, 1f, 1f));
        camera.clearFlags = CameraClearFlags.Skybox;
        camera.backgroundColor = Color.red;
        Flat(PrimitiveType.Cube, new Vector3(0f, -50f, 0f), Color.green).transform.localScale = new Vector3(900f, 100f, 900f);
    }
}
