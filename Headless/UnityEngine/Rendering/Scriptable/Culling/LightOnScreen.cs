using UnityEngine;
using UnityEngine.Rendering;

namespace Headless.Engine;

/// <summary>What of a picture a light may reach.</summary>
internal static class LightOnScreen
{
    private static readonly Rect Whole = new(0f, 0f, 1f, 1f);

    public static VisibleLight Of(Light light, in CameraView view)
    {
        if (light.type == LightType.Directional)
        {
            return new VisibleLight(light, Whole);
        }

        (Vector3 center, float radius) = CulledLights.Sphere(light);
        float along = Vector3.Dot(center - view.Position, view.Forward);
        return new VisibleLight(light, along - radius < view.Near ? Whole : Around(center, radius, view))
        {
            intersectsNearPlane = along - radius < view.Near && along + radius > view.Near,
            intersectsFarPlane = along - radius < view.Far && along + radius > view.Far,
        };
    }

    /// <summary>Of the corners of the cube round the sphere.</summary>
    private static Rect Around(Vector3 center, float radius, in CameraView view)
    {
        Matrix4x4 toClip = view.Projection * view.View;
        Vector2 min = Vector2.one;
        Vector2 max = -Vector2.one;
        for (int corner = 0; corner < 8; corner++)
        {
            var side = new Vector3((corner & 1) * 2 - 1, (corner & 2) - 1, ((corner & 4) / 2) - 1);
            Vector3 place = center + (view.View.inverse.MultiplyVector(side) * radius);
            Vector4 clip = toClip * new Vector4(place.x, place.y, place.z, 1f);
            var onScreen = new Vector2(clip.x / clip.w, clip.y / clip.w);
            min = Vector2.Min(min, onScreen);
            max = Vector2.Max(max, onScreen);
        }

        min = (Vector2.Max(min, -Vector2.one) + Vector2.one) * 0.5f;
        max = (Vector2.Min(max, Vector2.one) + Vector2.one) * 0.5f;
        return Rect.MinMaxRect(min.x, min.y, max.x, max.y);
    }
}
