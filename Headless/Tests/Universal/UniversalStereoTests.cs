using Headless.Engine;
using Headless.Tests.Rendering;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

namespace Headless.Tests.Universal;

/// <summary>Two eyes in the Universal Render Pipeline, against cameras of one picture at their places.</summary>
public sealed class UniversalStereoTests : UniversalFixture
{
    private const string Glass = """
        Shader "Test/Universal Glass"
        {
            SubShader
            {
                Tags { "Queue" = "Transparent" }
                Pass
                {
                    HLSLPROGRAM
                    #pragma target 4.5
                    #pragma vertex Vertex
                    #pragma fragment Fragment
                    #pragma multi_compile _ STEREO_INSTANCING_ON
                    float4x4 unity_ObjectToWorld;
                    struct Varyings
                    {
                        float4 position : SV_Position;
                        #if defined(STEREO_INSTANCING_ON)
                        uint eye : SV_RenderTargetArrayIndex;
                        #endif
                    };
                    #if defined(STEREO_INSTANCING_ON)
                    float4x4 unity_StereoMatrixVP[2];
                    Texture2DArray<float4> _CameraOpaqueTexture;
                    Texture2DArray<float> _CameraDepthTexture;
                    #else
                    float4x4 unity_MatrixVP;
                    Texture2D<float4> _CameraOpaqueTexture;
                    Texture2D<float> _CameraDepthTexture;
                    #endif
                    Varyings Vertex(float4 position : POSITION, uint instance : SV_InstanceID)
                    {
                        Varyings o;
                        float4 world = mul(unity_ObjectToWorld, position);
                        #if defined(STEREO_INSTANCING_ON)
                        o.eye = instance & 1u;
                        o.position = mul(unity_StereoMatrixVP[o.eye], world);
                        #else
                        o.position = mul(unity_MatrixVP, world);
                        #endif
                        return o;
                    }
                    float4 Fragment(Varyings i) : SV_Target
                    {
                        #if defined(STEREO_INSTANCING_ON)
                        int4 place = int4(i.position.xy, i.eye, 0);
                        #else
                        int3 place = int3(i.position.xy, 0);
                        #endif
                        return float4(_CameraOpaqueTexture.Load(place).grb * (0.5 + 0.5 * frac(20.0 * _CameraDepthTexture.Load(place))), 1.0);
                    }
                    ENDHLSL
                }
            }
        }
        """;

    [TearDown]
    public void CloseAnEye() => Stereo.Mode = StereoMode.Off;

    [Test]
    public void EachEyeSeesWhatACameraThereSees(
        [Values(StereoMode.MultiPass, StereoMode.Instanced)] object mode, [Values] bool hdr, [Values] DepthPrimingMode priming)
    {
        Asset.supportsHDR = hdr;
        Renderer.depthPrimingMode = priming;
        var eyes = new EyeCameras(Boxes((StereoMode)mode));
        Frame(2);
        eyes.AssertAlike($"urp-stereo-{mode}-{hdr}-{priming}");
    }

    // Depth and colour of the scene, which a pane reads, as textures or as arrays of two.
    [Test]
    public void EachEyeReadsItsCopiesOfTheScene([Values(StereoMode.MultiPass, StereoMode.Instanced)] object mode)
    {
        Set("m_OpaqueDownsampling", Downsampling.None);
        Set("m_RequireOpaqueTexture", true);
        Set("m_RequireDepthTexture", true);
        Renderer.copyDepthMode = CopyDepthMode.AfterOpaques;
        var eyes = new EyeCameras(Boxes((StereoMode)mode));
        GameObject pane = Flat(PrimitiveType.Quad, new Vector3(0f, 0f, -1.5f), Color.white);
        pane.transform.localScale = new Vector3(1.5f, 1.5f, 1f);
        pane.GetComponent<Renderer>().sharedMaterial = MaterialOf(Glass);
        Frame(2);
        eyes.AssertAlike($"urp-stereo-glass-{mode}");
    }

    // As URP does, a camera begins once for each pass.
    [TestCase(StereoMode.MultiPass, 2)]
    [TestCase(StereoMode.Instanced, 1)]
    public void ACameraBeginsOnceForEachPass(object mode, int times)
    {
        Boxes((StereoMode)mode);
        int begun = 0;
        void Count(ScriptableRenderContext context, Camera camera) => begun++;
        RenderPipelineManager.beginCameraRendering += Count;
        Frame();
        RenderPipelineManager.beginCameraRendering -= Count;
        Assert.That(begun, Is.EqualTo(times));
    }

    private Camera Boxes(StereoMode mode)
    {
        Stereo.Mode = mode;
        Camera camera = Camera(new Vector3(0.3f, 0.5f, -4f), Vector3.zero);
        camera.clearFlags = CameraClearFlags.Skybox;
        (camera.stereoSeparation, camera.stereoConvergence) = (0.4f, 5f);
        Sun(new Vector3(1f, -1f, 0.5f)).shadows = LightShadows.None;
        Flat(PrimitiveType.Cube, new Vector3(-1f, 0f, 1f), Color.red);
        Lit(PrimitiveType.Sphere, new Vector3(1f, 0.5f, 0f), Color.green);
        Lit(PrimitiveType.Cube, new Vector3(0.2f, -0.6f, 0.5f), Color.white);
        return camera;
    }
}
