using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;

namespace Headless.Tests.Rendering;

/// <summary>Textures that a script fills while a camera draws, read by a shader of the same picture.</summary>
public sealed class CameraCommandTests : SceneFixture
{
    // Turns red behind it into green; everything else stays black.
    private const string Glass = """
        Shader "Test/Glass"
        {
            SubShader
            {
                Tags { "Queue" = "Transparent" }
                Pass
                {
                    ZWrite Off
                    Cull Off
                    HLSLPROGRAM
                    #pragma vertex Vertex
                    #pragma fragment Fragment
                    #include "UnityCG.cginc"
                    Texture2D _SceneColor;
                    SamplerState sampler_SceneColor;
                    struct Varyings { float4 position : SV_POSITION; float4 screen : TEXCOORD0; };
                    Varyings Vertex(float4 position : POSITION)
                    {
                        Varyings o;
                        o.position = UnityObjectToClipPos(position);
                        o.screen = ComputeScreenPos(o.position);
                        return o;
                    }
                    float4 Fragment(Varyings i) : SV_Target { return float4(0, _SceneColor.Sample(sampler_SceneColor, i.screen.xy / i.screen.w).r, 0, 1); }
                    ENDHLSL
                }
            }
        }
        """;

    // Distance behind the glass: red, in tenths of a metre; green where the camera's matrices and sizes are right.
    private const string Depth = """
        Shader "Test/Depth"
        {
            SubShader
            {
                Tags { "Queue" = "Transparent" }
                Pass
                {
                    ZWrite Off
                    Cull Off
                    HLSLPROGRAM
                    #pragma vertex Vertex
                    #pragma fragment Fragment
                    #include "UnityCG.cginc"
                    Texture2D _CameraDepthTexture;
                    SamplerState sampler_CameraDepthTexture;
                    float4 _Expected;
                    struct Varyings { float4 position : SV_POSITION; float4 screen : TEXCOORD0; };
                    Varyings Vertex(float4 position : POSITION)
                    {
                        Varyings o;
                        o.position = UnityObjectToClipPos(position);
                        o.screen = ComputeScreenPos(o.position);
                        return o;
                    }
                    float4 Fragment(Varyings i) : SV_Target
                    {
                        float depth = LinearEyeDepth(_CameraDepthTexture.Sample(sampler_CameraDepthTexture, i.screen.xy / i.screen.w).r);
                        bool right = all(abs(_ProjectionParams.yz - _Expected.xy) < 1e-3) && all(_ScreenParams.xy == _Expected.zw);
                        bool pixel = all(abs(i.position.xy / _ScreenParams.xy - float2(i.screen.x, _ProjectionParams.x < 0 ? i.screen.y : i.screen.w - i.screen.y) / i.screen.w) < 1e-3);
                        return float4(depth / 10, right && pixel ? 1 : 0, 0, 1);
                    }
                    ENDHLSL
                }
            }
        }
        """;

    private const string Adding = """
        Shader "Test/Adding"
        {
            SubShader
            {
                Pass
                {
                    Blend One One
                    ZTest Always
                    ZWrite Off
                    Cull Off
                    HLSLPROGRAM
                    #pragma vertex Vertex
                    #pragma fragment Fragment
                    #pragma target 4.5
                    #include "UnityCG.cginc"
                    float4 Vertex(uint id : SV_VertexID) : SV_POSITION
                    {
                        float2 corner = float2(id == 1 || id == 2 || id == 4, id == 2 || id == 4 || id == 5);
                        return UnityWorldToClipPos(float3(corner * 2, 0));
                    }
                    float4 Fragment() : SV_Target { return float4(0.75, -0.25, 0.5, 1); }
                    ENDHLSL
                }
            }
        }
        """;

    private static readonly int SceneColor = Shader.PropertyToID("_SceneColor");

    [Test]
    public void TheSceneBehindTransparentThings([Values("screen", "multisampled", "part", "texture", "hdr")] string where)
    {
        Camera camera = Camera(new Vector3(0f, 0f, -5f), Vector3.zero);
        int antiAliasing = QualitySettings.antiAliasing;
        QualitySettings.antiAliasing = where == "multisampled" ? 4 : 0;
        camera.rect = where == "part" ? new Rect(0.5f, 0.25f, 0.5f, 0.5f) : new Rect(0f, 0f, 1f, 1f);
        camera.targetTexture = where switch
        {
            "texture" => new RenderTexture(100, 60, 24),
            "hdr" => new RenderTexture(100, 60, 24, RenderTextureFormat.ARGBHalf),
            _ => null,
        };
        Flat(PrimitiveType.Cube, new Vector3(1f, 1f, 0f), where == "hdr" ? new Color(8f, 0f, 0f) : Color.red);
        Pane(Glass);
        using var commands = new CommandBuffer();
        commands.GetTemporaryRT(SceneColor, -1, -1, 0, FilterMode.Bilinear, RenderTextureFormat.DefaultHDR);
        commands.Blit(BuiltinRenderTextureType.CurrentActive, SceneColor);
        commands.SetGlobalTexture(SceneColor, SceneColor);
        camera.AddCommandBuffer(CameraEvent.BeforeForwardAlpha, commands);
        try
        {
            Frame();
            Vector3 cube = camera.WorldToScreenPoint(new Vector3(1f, 1f, -0.5f));
            Vector3 mirrored = camera.WorldToScreenPoint(new Vector3(1f, -1f, -0.5f));
            if (where == "hdr")
            {
                var pixels = new Texture2D(100, 60, TextureFormat.RGBAHalf, false);
                RenderTexture.active = camera.targetTexture;
                pixels.ReadPixels(new Rect(0, 0, 100, 60), 0, 0, false);
                RenderTexture.active = null;
                Assert.That(pixels.GetPixel((int)cube.x, (int)cube.y).g, Is.EqualTo(new Color(8f, 0f, 0f).linear.r).Within(0.1f), "far above one");
                Assert.That(pixels.GetPixel((int)mirrored.x, (int)mirrored.y).g, Is.Zero);
                return;
            }

            Picture picture = camera.targetTexture is { } target ? Picture.Of(target) : Picture.OfScreen().Keep($"behind-{where}");
            Assert.That(IsGreen(picture.At(cube)), Is.True);
            Assert.That(IsBlack(picture.At(mirrored)), Is.True, "not upside down");
            Assert.That(picture.Share(IsRed), Is.Zero, "the pane covers everything");
        }
        finally
        {
            QualitySettings.antiAliasing = antiAliasing;
        }
    }

    [Test]
    public void TemporaryTexturesLiveUntilTheCameraHasDrawn()
    {
        Camera camera = Camera(new Vector3(0f, 0f, -5f), Vector3.zero);
        Flat(PrimitiveType.Cube, Vector3.zero, Color.red);
        Pane(Glass);
        using var taking = new CommandBuffer();
        taking.GetTemporaryRT(SceneColor, -1, -1);
        taking.Blit(BuiltinRenderTextureType.CurrentActive, SceneColor);
        camera.AddCommandBuffer(CameraEvent.AfterForwardOpaque, taking);

        // A second texture of the same shape must not be the same texture.
        using var other = new CommandBuffer();
        other.GetTemporaryRT(Shader.PropertyToID("_Other"), -1, -1);
        other.SetRenderTarget(Shader.PropertyToID("_Other"));
        other.ClearRenderTarget(false, true, Color.black);
        camera.AddCommandBuffer(CameraEvent.BeforeForwardAlpha, other);
        Frame();
        Assert.That(IsGreen(Picture.OfScreen().At(64, 48)), Is.True);
    }

    [Test]
    public void TheDepthTextureHoldsOpaqueThingsOnly([Values] bool intoATexture)
    {
        Camera camera = Camera(new Vector3(0f, 0f, -5f), Vector3.zero);
        camera.nearClipPlane = 0.2f;
        camera.farClipPlane = 40f;
        camera.targetTexture = intoATexture ? new RenderTexture(100, 60, 24) : null;
        GameObject cube = Primitive(PrimitiveType.Cube, new Vector3(1f, 1f, 1.5f));
        cube.GetComponent<Renderer>().shadowCastingMode = ShadowCastingMode.Off;
        Material pane = Pane(Depth).GetComponent<Renderer>().sharedMaterial!;
        pane.SetVector("_Expected", new Vector4(0.2f, 40f, camera.pixelWidth, camera.pixelHeight));

        // Another transparent thing before the camera, with a caster of its own, must not be in it.
        GameObject veil = Primitive(PrimitiveType.Quad, new Vector3(0f, 0f, -3f));
        veil.transform.localScale = Vector3.one * 10f;
        Material invisible = veil.GetComponent<Renderer>().material!;
        invisible.renderQueue = (int)RenderQueue.Transparent;
        invisible.SetFloat("_SrcBlend", (float)BlendMode.Zero);
        invisible.SetFloat("_DstBlend", (float)BlendMode.One);
        invisible.SetFloat("_ZWrite", 0f);
        Camera.CameraCallback ask = c => c.depthTextureMode |= DepthTextureMode.Depth;
        UnityEngine.Camera.onPreCull += ask;
        try
        {
            Frame();
        }
        finally
        {
            UnityEngine.Camera.onPreCull -= ask;
        }

        Picture picture = camera.targetTexture is { } target ? Picture.Of(target) : Picture.OfScreen();
        Color32 near = picture.At(camera.WorldToScreenPoint(new Vector3(1f, 1f, 1f)));
        Color32 far = picture.At(camera.WorldToScreenPoint(new Vector3(1f, -1f, 1f)));
        Assert.That(((Color)near).linear.r, Is.EqualTo(0.6f).Within(0.01f), "six metres");
        Assert.That((near.g, far.r, far.g), Is.EqualTo(((byte)255, (byte)255, (byte)255)), "the far plane, and the camera's variables");
    }

    [Test]
    public void DrawsOfItsOwnBeforeTheCamera([Values(RenderTextureFormat.RGHalf, RenderTextureFormat.RGFloat, RenderTextureFormat.ARGBHalf)] RenderTextureFormat format)
    {
        Assert.That(SystemInfo.SupportsRenderTextureFormat(format) && SystemInfo.SupportsBlendingOnRenderTextureFormat(format), Is.True);
        Camera camera = Camera(new Vector3(0f, 0f, -5f), Vector3.zero);
        Pane(Glass);
        Material adding = MaterialOf(Adding);
        var sums = new RenderTexture(64, 48, 0, format) { filterMode = FilterMode.Point };
        using var commands = new CommandBuffer();
        int seen = 0;
        Camera.CameraCallback draw = c =>
        {
            seen++;
            commands.Clear();
            commands.SetRenderTarget(sums);
            commands.ClearRenderTarget(false, true, Color.clear);
            commands.SetViewProjectionMatrices(c.worldToCameraMatrix, c.projectionMatrix);
            commands.DrawProcedural(Matrix4x4.identity, adding, 0, MeshTopology.Triangles, 6);
            commands.DrawProcedural(Matrix4x4.identity, adding, 0, MeshTopology.Triangles, 6);
            Graphics.ExecuteCommandBuffer(commands);
            Shader.SetGlobalTexture(SceneColor, sums);
        };
        UnityEngine.Camera.onPreCull += draw;
        try
        {
            Frame();
        }
        finally
        {
            UnityEngine.Camera.onPreCull -= draw;
        }

        Assert.That(seen, Is.EqualTo(1));
        Picture picture = Picture.OfScreen().Keep($"sums-{format}");
        Assert.That(IsGreen(picture.At(camera.WorldToScreenPoint(new Vector3(1f, 1f, 0f)))), Is.True, "0.75 + 0.75, clamped by the screen only");
        Assert.That(IsBlack(picture.At(camera.WorldToScreenPoint(new Vector3(1f, -1f, 0f)))), Is.True, "not upside down");
        var pixels = new Texture2D(64, 48, TextureFormat.RGBAFloat, false);
        RenderTexture.active = sums;
        pixels.ReadPixels(new Rect(0, 0, 64, 48), 0, 0, false);
        RenderTexture.active = null;
        Vector3 inside = camera.WorldToViewportPoint(new Vector3(1f, 1f, 0f));
        Color sum = pixels.GetPixel((int)(inside.x * 64), (int)(inside.y * 48));
        Assert.That((sum.r, sum.g), Is.EqualTo((1.5f, -0.5f)));
    }

    private GameObject Pane(string shader)
    {
        GameObject pane = GameObject.CreatePrimitive(PrimitiveType.Quad);
        pane.transform.position = new Vector3(0f, 0f, -2f);
        pane.transform.localScale = Vector3.one * 20f;
        pane.GetComponent<Renderer>().sharedMaterial = MaterialOf(shader);
        return pane;
    }
}
