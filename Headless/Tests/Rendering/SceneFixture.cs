using UnityEngine;
using UnityEngine.Rendering;

namespace Headless.Tests.Rendering;

/// <summary>Cameras, lights and objects for pictures.</summary>
public abstract class SceneFixture : RenderFixture
{
    protected const string FlatShader = """
        Shader "Test/Flat"
        {
            Properties { _Color ("Color", Color) = (1, 1, 1, 1) }
            SubShader
            {
                Pass
                {
                    HLSLPROGRAM
                    #pragma vertex Vertex
                    #pragma fragment Fragment
                    #include "UnityCG.cginc"
                    float4 _Color;
                    float4 Vertex(float4 position : POSITION) : SV_POSITION { return UnityObjectToClipPos(position); }
                    float4 Fragment() : SV_Target { return _Color; }
                    ENDHLSL
                }
            }
        }
        """;

    protected static Camera Camera(Vector3 position, Vector3 target)
    {
        var camera = new GameObject("Camera").AddComponent<Camera>();
        camera.tag = "MainCamera";
        camera.transform.position = position;
        camera.transform.LookAt(target);
        camera.clearFlags = CameraClearFlags.SolidColor;
        camera.backgroundColor = Color.black;
        return camera;
    }

    protected static Light Sun(Vector3 direction)
    {
        var light = new GameObject("Sun").AddComponent<Light>();
        light.type = LightType.Directional;
        light.shadows = LightShadows.Soft;
        light.transform.rotation = Quaternion.LookRotation(direction);
        return light;
    }

    protected static GameObject Primitive(PrimitiveType type, Vector3 position, Color? color = null)
    {
        GameObject primitive = GameObject.CreatePrimitive(type);
        primitive.transform.position = position;
        if (color is { } c)
        {
            primitive.GetComponent<Renderer>().material!.color = c;
        }

        return primitive;
    }

    protected GameObject Flat(PrimitiveType type, Vector3 position, Color color)
    {
        GameObject primitive = GameObject.CreatePrimitive(type);
        primitive.transform.position = position;
        Material material = MaterialOf(FlatShader);
        material.SetColor("_Color", color);
        primitive.GetComponent<Renderer>().sharedMaterial = material;
        return primitive;
    }

    protected static bool IsRed(Color32 c) => c.r > 200 && c.g < 60 && c.b < 60;

    protected static bool IsGreen(Color32 c) => c.g > 200 && c.r < 60 && c.b < 60;

    protected static bool IsBlack(Color32 c) => c.r < 8 && c.g < 8 && c.b < 8;
}
