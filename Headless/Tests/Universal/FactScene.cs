using UnityEngine;
using UnityEngine.Rendering.Universal;

namespace Headless.Tests.Universal;

/// <summary>What the facts are computed from.</summary>
/// <param name="Camera">Draws through textures of its own: HDR is on.</param>
/// <param name="Sun">The main light, with soft shadows.</param>
/// <param name="Lamp">A point light.</param>
/// <param name="Spot">A spot light.</param>
/// <param name="Asset">The settings.</param>
public sealed record FactScene(Camera Camera, Light Sun, Light Lamp, Light Spot, UniversalRenderPipelineAsset Asset)
{
    public Vector2 Size => new(Camera.pixelWidth, Camera.pixelHeight);
    public Vector2 TargetSize => new((int)(Camera.pixelWidth * Asset.renderScale), (int)(Camera.pixelHeight * Asset.renderScale));

    /// <summary>As a device with reversed depth and textures that begin at the top has it.</summary>
    public Matrix4x4 DeviceProjection
    {
        get
        {
            Matrix4x4 projection = Camera.projectionMatrix;
            projection.SetRow(1, -projection.GetRow(1));
            projection.SetRow(2, (projection.GetRow(3) - projection.GetRow(2)) * 0.5f);
            return projection;
        }
    }

    public Matrix4x4 View => Matrix4x4.Scale(new Vector3(1f, 1f, -1f)) * Camera.transform.worldToLocalMatrix;

    public static Vector4[] Rows(Matrix4x4 m) => [m.GetRow(0), m.GetRow(1), m.GetRow(2), m.GetRow(3)];

    /// <summary>Of the light's own matrix: where it stands, and where it points.</summary>
    public static Vector4 Toward(Light light)
    {
        Vector3 back = -light.transform.forward;
        return new Vector4(back.x, back.y, back.z, 0f);
    }

    public static Vector4 Place(Light light)
    {
        Vector3 at = light.transform.position;
        return new Vector4(at.x, at.y, at.z, 1f);
    }

    public static Vector4 Linear(Light light, float w)
    {
        Color color = light.color.linear * light.intensity;
        return new Vector4(color.r, color.g, color.b, w);
    }
}
