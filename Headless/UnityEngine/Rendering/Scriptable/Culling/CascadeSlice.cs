using UnityEngine;

namespace Headless.Engine;

/// <summary>The smallest sphere on the camera's axis around a slice of what it sees.</summary>
internal readonly record struct CascadeSlice(Vector3 Center, float Radius)
{
    /// <param name="ratio">Where the first three slices end, as shares of the distance.</param>
    public static CascadeSlice Of(in CameraView view, float distance, int index, int count, Vector3 ratio)
    {
        float near = index == 0 ? view.Near : ratio[index - 1] * distance;
        float far = index == count - 1 ? distance : ratio[index] * distance;
        float width = 1f / view.Projection.m00;
        float height = 1f / view.Projection.m11;
        float corner = (width * width) + (height * height);
        if (view.Orthographic)
        {
            float half = (far - near) * 0.5f;
            return At(view, near + half, Mathf.Sqrt(corner + (half * half)));
        }

        // As far from the corners of the near end as from those of the far end, but not beyond the far end.
        float middle = Mathf.Min(far, (near + far) * 0.5f * (1f + corner));
        return At(view, middle, Mathf.Sqrt(((far - middle) * (far - middle)) + (far * far * corner)));
    }

    private static CascadeSlice At(in CameraView view, float distance, float radius) =>
        new(view.View.inverse.MultiplyPoint3x4(Vector3.back * distance), radius);
}
