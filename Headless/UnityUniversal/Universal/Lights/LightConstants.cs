namespace UnityEngine.Rendering.Universal;

/// <summary>A light as shaders of the pipeline see it.</summary>
/// <param name="Position">To a directional light, w 0; of another, w 1.</param>
/// <param name="Color">Linear, intensity included.</param>
/// <param name="Attenuation">x: 1 / range²; y: of the smooth end at the range; z, w: of a spot's cone.</param>
/// <param name="SpotDirection">Against the light's own.</param>
internal readonly record struct LightConstants(Vector4 Position, Vector4 Color, Vector4 Attenuation, Vector4 SpotDirection)
{
    /// <summary>Narrower cones lose their attenuation to rounding.</summary>
    private const float LeastAngle = 2.6f;

    /// <summary>Of no light: black, from the front.</summary>
    public static LightConstants None { get; } = new(new Vector4(0f, 0f, 1f, 0f), new Vector4(0f, 0f, 0f, 1f), new Vector4(0f, 1f, 0f, 1f), new Vector4(0f, 0f, 1f, 0f));

    public static LightConstants Of(in VisibleLight light)
    {
        Matrix4x4 place = light.localToWorldMatrix;
        Vector4 back = -place.GetColumn(2);
        Vector4 color = light.finalColor;
        if (light.lightType == LightType.Directional)
        {
            return None with { Position = new Vector4(back.x, back.y, back.z, 0f), Color = color };
        }

        Vector4 at = place.GetColumn(3);
        bool isSpot = light.lightType == LightType.Spot;
        Vector2 cone = isSpot ? Cone(light) : new Vector2(0f, 1f);
        float squared = light.range * light.range;

        // 1 up to 0.8 of the range, 0 at the range: over r², whose span is (1 - 0.64) range².
        var attenuation = new Vector4(1f / Mathf.Max(0.0001f, squared), 1f / (1f - 0.64f), cone.x, cone.y);
        return new LightConstants(new Vector4(at.x, at.y, at.z, 1f), color, attenuation, isSpot ? new Vector4(back.x, back.y, back.z, 0f) : None.SpotDirection);
    }

    private static Vector2 Cone(in VisibleLight light)
    {
        float outer = Mathf.Max(light.spotAngle, LeastAngle);
        float inner = Mathf.Max(0f, light.light.innerSpotAngle);
        inner = light.spotAngle < LeastAngle ? Mathf.Min(inner, LeastAngle) : inner;
        float cosOuter = Mathf.Cos(outer * 0.5f * Mathf.Deg2Rad);
        float range = Mathf.Max(0.001f, Mathf.Cos(inner * 0.5f * Mathf.Deg2Rad) - cosOuter);
        return new Vector2(1f / range, -cosOuter / range);
    }
}
