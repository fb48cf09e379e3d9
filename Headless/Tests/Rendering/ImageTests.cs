using Headless.Engine;
using NUnit.Framework;
using UnityEngine;

namespace Headless.Tests.Rendering;

public sealed class ImageTests : SceneFixture
{
    private const string Swap = """
        Shader "Test/Swap"
        {
            Properties { _MainTex ("Texture", 2D) = "white" {} }
            SubShader
            {
                Cull Off ZWrite Off ZTest Always
                Pass
                {
                    HLSLPROGRAM
                    #pragma vertex vert_img
                    #pragma fragment Fragment
                    #include "UnityCG.cginc"
                    Texture2D _MainTex;
                    SamplerState sampler_MainTex;
                    float4 _MainTex_TexelSize;
                    float4 Fragment(v2f_img i) : SV_Target
                    {
                        float4 c = _MainTex.Sample(sampler_MainTex, i.uv);
                        return float4(c.g, c.r, _MainTex_TexelSize.z == 128 ? 0 : 1, 1);
                    }
                    ENDHLSL
                }
            }
        }
        """;

    [TestCase(1)]
    [TestCase(2)]
    [TestCase(3)]
    public void EffectsRunInAChainAndKeepThePictureUpright(int count)
    {
        Camera camera = Camera(new Vector3(0f, 0f, -5f), Vector3.zero);
        Flat(PrimitiveType.Cube, new Vector3(0f, 1f, 0f), Color.red);
        for (int i = 0; i < count; i++)
        {
            camera.gameObject.AddComponent<InvertEffect>().Effect = MaterialOf(Swap);
        }

        Frame();
        Picture picture = Picture.OfScreen();
        Color32 at = picture.At(camera.WorldToScreenPoint(new Vector3(0f, 1f, -0.5f)));
        Assert.That(count % 2 == 1 ? IsGreen(at) : IsRed(at), Is.True, at.ToString());
        Assert.That(IsBlack(picture.At(64, 10)), Is.True);

        // The same with a texture as the camera's target.
        var texture = new RenderTexture(128, 96, 24);
        camera.targetTexture = texture;
        camera.Render();
        at = Picture.Of(texture).At(camera.WorldToScreenPoint(new Vector3(0f, 1f, -0.5f)));
        Assert.That(count % 2 == 1 ? IsGreen(at) : IsRed(at), Is.True, at.ToString());
    }

    [Test]
    public void BlitsKeepPixels()
    {
        var source = new Texture2D(8, 8, TextureFormat.RGBA32, false, true) { filterMode = FilterMode.Point };
        for (int i = 0; i < 64; i++)
        {
            source.SetPixel(i % 8, i / 8, new Color(i % 8 / 7f, i / 8 / 7f, 0f, 1f));
        }

        source.Apply();
        var target = new RenderTexture(8, 8, 0, RenderTextureFormat.ARGB32, RenderTextureReadWrite.Linear);
        Graphics.Blit(source, target);
        RenderTexture.active = target;
        var read = new Texture2D(8, 8, TextureFormat.RGBA32, false, true);
        read.ReadPixels(new Rect(0, 0, 8, 8), 0, 0);
        RenderTexture.active = null;
        Assert.That(read.GetPixels32(), Is.EqualTo(source.GetPixels32()));
    }

    [Test]
    public void PngFilesGoRoundUnchanged()
    {
        var image = new Texture2D(5, 3, TextureFormat.RGBA32, false);
        var random = new System.Random(4);
        for (int i = 0; i < 15; i++)
        {
            image.SetPixel(i % 5, i / 5, new Color32((byte)random.Next(256), (byte)random.Next(256), (byte)random.Next(256), (byte)random.Next(256)));
        }

        byte[] file = image.EncodeToPNG();
        var back = new Texture2D(2, 2);
        Assert.That(back.LoadImage(file), Is.True);
        Assert.That((back.width, back.height), Is.EqualTo((5, 3)));
        Assert.That(back.GetPixels32(), Is.EqualTo(image.GetPixels32()));
        Assert.That(back.LoadImage([1, 2, 3]), Is.False);
    }

    [Test]
    public void FramesComeBackInOrderWithoutWaiting()
    {
        Camera camera = Camera(new Vector3(0f, 0f, -5f), Vector3.zero);
        var ring = new ScreenReadback();
        var seen = new List<(int Frame, byte Red)>();
        for (int i = 0; i < 6; i++)
        {
            camera.backgroundColor = new Color(i / 5f, 0f, 0f, 1f);
            Frame();
            ring.Capture(i);
            while (ring.TryTake(false, out CapturedFrame frame))
            {
                seen.Add((frame.Frame, frame.Pixels[0]));
            }
        }

        while (ring.TryTake(true, out CapturedFrame frame))
        {
            seen.Add((frame.Frame, frame.Pixels[0]));
        }

        Assert.That(seen.Select(s => s.Frame), Is.EqualTo(Enumerable.Range(0, 6)));
        Assert.That(seen.Select(s => (int)s.Red), Is.EqualTo(new[] { 0, 51, 102, 153, 204, 255 }).Within(1));
    }

    [Test]
    public void TheCameraDepthTextureHoldsReversedDepth()
    {
        Camera camera = Camera(new Vector3(0f, 0f, -5f), Vector3.zero);
        camera.nearClipPlane = 1f;
        camera.farClipPlane = 10f;
        camera.depthTextureMode = DepthTextureMode.Depth;
        Primitive(PrimitiveType.Cube, new Vector3(0f, 0f, 0.5f));
        camera.gameObject.AddComponent<InvertEffect>().Effect = MaterialOf(Swap
            .Replace("float4 c = _MainTex.Sample(sampler_MainTex, i.uv);", "float eye = LinearEyeDepth(_CameraDepthTexture.Sample(sampler_CameraDepthTexture, i.uv).r); float4 c = 0;")
            .Replace("return float4(c.g, c.r, _MainTex_TexelSize.z == 128 ? 0 : 1, 1);", "return float4(eye > 4.9 && eye < 5.1 ? 1 : 0, eye > 9.9 ? 1 : 0, 0, 1);")
            .Replace("float4 _MainTex_TexelSize;", "Texture2D _CameraDepthTexture; SamplerState sampler_CameraDepthTexture;"));
        Frame();
        Picture picture = Picture.OfScreen();
        Assert.That(IsRed(picture.At(64, 48)), Is.True, "the front of the cube is five metres away");
        Assert.That(IsGreen(picture.At(5, 5)), Is.True, "the background is at the far plane");
    }
}
