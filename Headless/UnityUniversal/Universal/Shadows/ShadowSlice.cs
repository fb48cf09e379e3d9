using UnityEngine.Rendering.RenderGraphModule;

namespace UnityEngine.Rendering.Universal;

/// <summary>One square of a shadow atlas: where it lies, and from where it is drawn.</summary>
internal readonly record struct ShadowSlice(Matrix4x4 View, Matrix4x4 Projection, ShadowSplitData Split, int X, int Y, int Resolution)
{
    // In units of depth and in slopes.
    private const float DepthBias = 1f;
    private const float SlopeBias = 2.5f;

    private static readonly int ShadowBias = Shader.PropertyToID("_ShadowBias");
    private static readonly int LightDirection = Shader.PropertyToID("_LightDirection");
    private static readonly int LightPosition = Shader.PropertyToID("_LightPosition");

    /// <summary>From the world to the slice's place in an atlas of this size, depth as the device has it.</summary>
    public Matrix4x4 WorldToAtlas(int width, int height)
    {
        Matrix4x4 projection = Projection;
        if (SystemInfo.usesReversedZBuffer)
        {
            projection.SetRow(2, -projection.GetRow(2));
        }

        var toTexture = Matrix4x4.identity;
        (toTexture.m00, toTexture.m11, toTexture.m22) = (0.5f, 0.5f, 0.5f);
        (toTexture.m03, toTexture.m13, toTexture.m23) = (0.5f, 0.5f, 0.5f);
        var toSlice = Matrix4x4.identity;
        (toSlice.m00, toSlice.m11) = ((float)Resolution / width, (float)Resolution / height);
        (toSlice.m03, toSlice.m13) = ((float)X / width, (float)Y / height);
        return toSlice * toTexture * projection * View;
    }

    public void Draw(RasterCommandBuffer cmd, RendererList casters)
    {
        cmd.SetGlobalDepthBias(DepthBias, SlopeBias);
        cmd.SetViewport(new Rect(X, Y, Resolution, Resolution));
        cmd.SetViewProjectionMatrices(View, Projection);
        cmd.DrawRendererList(casters);
        cmd.DisableScissorRect();
        cmd.SetGlobalDepthBias(0f, 0f);
    }

    /// <summary>What casters are moved by: along the light and along their normals, in metres.</summary>
    public Vector4 Bias(in VisibleLight light, Vector4 bias, bool softShadows)
    {
        float width = light.lightType switch
        {
            LightType.Directional => 2f / Projection.m00,
            LightType.Spot => Mathf.Tan(light.spotAngle * 0.5f * Mathf.Deg2Rad) * light.range,
            _ => light.range,
        };
        float texel = width / Resolution * (softShadows && light.light.shadows == LightShadows.Soft ? KernelRadius(light.light) : 1f);
        return new Vector4(-bias.x * texel, light.lightType == LightType.Point ? 0f : -bias.y * texel, (float)light.lightType, 0f);
    }

    public static void SetCaster(RasterCommandBuffer cmd, in VisibleLight light, Vector4 bias)
    {
        Vector3 toLight = -light.localToWorldMatrix.GetColumn(2);
        Vector3 position = light.localToWorldMatrix.GetColumn(3);
        cmd.SetGlobalVector(ShadowBias, bias);
        cmd.SetGlobalVector(LightDirection, new Vector4(toLight.x, toLight.y, toLight.z, 0f));
        cmd.SetGlobalVector(LightPosition, new Vector4(position.x, position.y, position.z, 1f));
    }

    /// <summary>Scale and bias of the fade over the squared distance from the camera.</summary>
    public static (float Scale, float Bias) Fade(float squaredDistance, float border)
    {
        if (border < 0.0001f)
        {
            return (1000f, -squaredDistance * 1000f);
        }

        float near = (1f - border) * (1f - border) * squaredDistance;
        return (1f / (squaredDistance - near), -near / (squaredDistance - near));
    }

    /// <summary>0: hard; 1: soft; a light with settings of its own gives the quality, from 1, low, to 3, high.</summary>
    public static float Softness(Light light, bool isSoft)
    {
        if (!isSoft)
        {
            return 0f;
        }

        if (!light.TryGetComponent(out UniversalAdditionalLightData data))
        {
            return 1f;
        }

        SoftShadowQuality quality = data.softShadowQuality == SoftShadowQuality.UsePipelineSettings ? UniversalRenderPipeline.asset!.SoftShadowQuality : data.softShadowQuality;
        return Mathf.Max((int)quality, (int)SoftShadowQuality.Low);
    }

    private static float KernelRadius(Light light) =>
        (light.TryGetComponent(out UniversalAdditionalLightData data) ? data.softShadowQuality : SoftShadowQuality.Medium) switch
        {
            SoftShadowQuality.High => 3.5f,
            SoftShadowQuality.Low => 1.5f,
            _ => 2.5f,
        };
}
