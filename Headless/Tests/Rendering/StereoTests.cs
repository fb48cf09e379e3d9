using Headless.Engine;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.XR;

namespace Headless.Tests.Rendering;

/// <summary>Two eyes in the built-in pipeline, against cameras of one picture at their places.</summary>
public sealed class StereoTests : SceneFixture
{
    private const string StereoShader = """
        Shader "Test/Stereo"
        {
            SubShader
            {
                Pass
                {
                    HLSLPROGRAM
                    #pragma vertex Vertex
                    #pragma fragment Fragment
                    #pragma multi_compile _ STEREO_INSTANCING_ON
                    #include "UnityCG.cginc"
                    struct Attributes { float4 position : POSITION; UNITY_VERTEX_INPUT_INSTANCE_ID };
                    struct Varyings { float4 position : SV_POSITION; float3 world : TEXCOORD0; UNITY_VERTEX_OUTPUT_STEREO };
                    Varyings Vertex(Attributes v)
                    {
                        Varyings o;
                        UNITY_SETUP_INSTANCE_ID(v);
                        UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(o);
                        o.position = UnityObjectToClipPos(v.position);
                        o.world = mul(unity_ObjectToWorld, v.position).xyz;
                        return o;
                    }
                    float4 Fragment(Varyings i) : SV_Target
                    {
                        UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(i);
                        return float4(frac(2.0 * (_WorldSpaceCameraPos - i.world)), 1.0);
                    }
                    ENDHLSL
                }
            }
        }
        """;

    [TearDown]
    public void CloseAnEye() => Stereo.Mode = StereoMode.Off;

    [TestCase(StereoMode.MultiPass, 1)]
    [TestCase(StereoMode.MultiPass, 4)]
    [TestCase(StereoMode.Instanced, 1)]
    public void EachEyeSeesWhatACameraThereSees(object mode, int samples)
    {
        int before = QualitySettings.antiAliasing;
        QualitySettings.antiAliasing = samples;
        Camera camera = Boxes((StereoMode)mode);
        var eyes = new EyeCameras(camera);
        Frame(2);
        QualitySettings.antiAliasing = before;
        eyes.AssertAlike($"stereo-{mode}-{samples}");
    }

    [TestCase(StereoMode.MultiPass)]
    [TestCase(StereoMode.Instanced)]
    public void EachEyeReadsItsCopiesOfTheScene(object mode)
    {
        Camera camera = Boxes((StereoMode)mode);
        camera.depthTextureMode = DepthTextureMode.Depth;
        GameObject pane = Flat(PrimitiveType.Quad, new Vector3(0f, 0f, -1.5f), Color.white);
        pane.transform.localScale = new Vector3(1.5f, 1.5f, 1f);
        Material glass = MaterialOf("""
            Shader "Test/Glass"
            {
                SubShader
                {
                    Tags { "Queue" = "Transparent" }
                    Pass
                    {
                        HLSLPROGRAM
                        #pragma vertex Vertex
                        #pragma fragment Fragment
                        #pragma multi_compile _ STEREO_INSTANCING_ON
                        #include "UnityCG.cginc"
                        #if defined(STEREO_INSTANCING_ON)
                        Texture2DArray<float4> _Behind; Texture2DArray<float> _CameraDepthTexture;
                        #else
                        Texture2D<float4> _Behind; Texture2D<float> _CameraDepthTexture;
                        #endif
                        struct Attributes { float4 position : POSITION; UNITY_VERTEX_INPUT_INSTANCE_ID };
                        struct Varyings { float4 position : SV_POSITION; UNITY_VERTEX_OUTPUT_STEREO };
                        Varyings Vertex(Attributes v)
                        {
                            Varyings o;
                            UNITY_SETUP_INSTANCE_ID(v);
                            UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(o);
                            o.position = UnityObjectToClipPos(v.position);
                            return o;
                        }
                        float4 Fragment(Varyings i) : SV_Target
                        {
                            UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(i);
                            #if defined(STEREO_INSTANCING_ON)
                            int4 place = int4(i.position.xy, unity_StereoEyeIndex, 0);
                            #else
                            int3 place = int3(i.position.xy, 0);
                            #endif
                            return float4(_Behind.Load(place).grb * (0.5 + 0.5 * frac(20.0 * _CameraDepthTexture.Load(place))), 1.0);
                        }
                        ENDHLSL
                    }
                }
            }
            """);
        pane.GetComponent<Renderer>().sharedMaterial = glass;
        var copy = new CommandBuffer();
        int behind = Shader.PropertyToID("_Behind");
        var eyes = new EyeCameras(camera);
        foreach (Camera each in UnityEngine.Camera.allCameras)
        {
            each.depthTextureMode = DepthTextureMode.Depth;
            each.AddCommandBuffer(CameraEvent.BeforeForwardAlpha, copy);
        }

        UnityEngine.Camera.onPreCull += Record;
        Frame(2);
        UnityEngine.Camera.onPreCull -= Record;
        eyes.AssertAlike($"stereo-glass-{mode}");

        void Record(Camera each)
        {
            copy.Clear();
            RenderTextureDescriptor size = each.stereoEnabled
                ? XRSettings.eyeTextureDesc
                : new RenderTextureDescriptor(each.pixelWidth, each.pixelHeight, RenderTextureFormat.ARGB32, 0);
            size.depthBufferBits = 0;
            copy.GetTemporaryRT(behind, size, FilterMode.Point);
            copy.Blit(BuiltinRenderTextureType.CurrentActive, new RenderTargetIdentifier(behind, 0, CubemapFace.Unknown, RenderTargetIdentifier.AllDepthSlices));
        }
    }

    [Test]
    public void CallbacksKnowTheEye([Values(StereoMode.MultiPass, StereoMode.Instanced)] object mode)
    {
        Camera camera = Boxes((StereoMode)mode);
        var culled = new List<Camera.MonoOrStereoscopicEye>();
        var drawn = new List<Camera.MonoOrStereoscopicEye>();
        UnityEngine.Camera.CameraCallback cull = c => culled.Add(c.stereoActiveEye), draw = c => drawn.Add(c.stereoActiveEye);
        UnityEngine.Camera.onPreCull += cull;
        UnityEngine.Camera.onPreRender += draw;
        Frame();
        UnityEngine.Camera.onPreCull -= cull;
        UnityEngine.Camera.onPreRender -= draw;
        Assert.That(culled, Is.EqualTo(new[] { UnityEngine.Camera.MonoOrStereoscopicEye.Left }));
        Assert.That(drawn, Is.EqualTo(mode is StereoMode.Instanced
            ? [UnityEngine.Camera.MonoOrStereoscopicEye.Left]
            : new[] { UnityEngine.Camera.MonoOrStereoscopicEye.Left, UnityEngine.Camera.MonoOrStereoscopicEye.Right }));
        Assert.That(XRSettings.eyeTextureDesc.volumeDepth, Is.EqualTo(mode is StereoMode.Instanced ? 2 : 1));
        Assert.That((camera.pixelWidth, camera.pixelHeight), Is.EqualTo((64, 96)));
        Stereo.Mode = StereoMode.Off;
        Assert.That(camera.stereoActiveEye, Is.EqualTo(UnityEngine.Camera.MonoOrStereoscopicEye.Mono));
    }

    // Corners of both eyes' views lie in the one that objects are culled with, and little else does.
    [Test]
    public void CullingSeesWithBothEyes([Values] bool orthographic)
    {
        Camera camera = Boxes(StereoMode.MultiPass);
        camera.orthographic = orthographic;
        Matrix4x4 hull = camera.cullingMatrix;
        float widest = 0f;
        foreach (Camera.StereoscopicEye eye in new[] { UnityEngine.Camera.StereoscopicEye.Left, UnityEngine.Camera.StereoscopicEye.Right })
        {
            Matrix4x4 back = (camera.GetStereoProjectionMatrix(eye) * camera.GetStereoViewMatrix(eye)).inverse;
            for (int i = 0; i < 8; i++)
            {
                Vector3 seen = hull.MultiplyPoint(back.MultiplyPoint(new Vector3((i & 1) * 2 - 1, (i & 2) - 1, (i & 4) / 2 - 1)));
                Assert.That(Mathf.Max(Mathf.Abs(seen.x), Mathf.Max(Mathf.Abs(seen.y), Mathf.Abs(seen.z))), Is.LessThan(1.001f));
                widest = Mathf.Max(widest, Mathf.Abs(seen.x));
            }
        }

        Assert.That(widest, Is.GreaterThan(0.95f));
    }

    private Camera Boxes(StereoMode mode)
    {
        Stereo.Mode = mode;
        Camera camera = Camera(new Vector3(0.3f, 0.5f, -4f), Vector3.zero);
        camera.clearFlags = CameraClearFlags.Skybox;
        (camera.stereoSeparation, camera.stereoConvergence) = (0.4f, 5f);
        Sun(new Vector3(1f, -1f, 0.5f)).shadows = LightShadows.None;
        Flat(PrimitiveType.Cube, new Vector3(-1f, 0f, 1f), Color.red);
        Primitive(PrimitiveType.Sphere, new Vector3(1f, 0.5f, 0f), Color.green);
        GameObject box = Flat(PrimitiveType.Cube, new Vector3(0.2f, -0.6f, 0.5f), Color.white);
        box.GetComponent<Renderer>().sharedMaterial = MaterialOf(StereoShader);
        return camera;
    }
}
