using UnityEngine;

namespace Headless.Engine;

/// <summary>Primitives with Unity's dimensions: cube side 1, sphere radius 0.5, capsule and cylinder height 2, plane 10 x 10, quad 1 x 1.</summary>
internal static class PrimitiveShapes
{
    private const int Around = 32;
    private const float Radius = 0.5f;

    public static Mesh Build(PrimitiveType type) => type switch
    {
        PrimitiveType.Sphere => Round(0f, 16),
        PrimitiveType.Capsule => Round(0.5f, 16),
        PrimitiveType.Cylinder => Cylinder(),
        PrimitiveType.Plane => Plane(),
        PrimitiveType.Quad => Quad(),
        _ => Cube(),
    };

    private static Mesh Cube()
    {
        var shape = new ShapeBuilder();
        foreach (Vector3 normal in (Vector3[])[Vector3.forward, Vector3.up, Vector3.back, Vector3.down, Vector3.left, Vector3.right])
        {
            Vector3 up = Mathf.Abs(normal.y) > 0.5f ? Vector3.forward : Vector3.up;
            Vector3 right = Vector3.Cross(normal, up);
            Vector3 center = normal * 0.5f;
            int a = shape.Add(center + ((-right - up) * 0.5f), normal, new Vector2(0f, 0f));
            int b = shape.Add(center + ((-right + up) * 0.5f), normal, new Vector2(0f, 1f));
            int c = shape.Add(center + ((right + up) * 0.5f), normal, new Vector2(1f, 1f));
            int d = shape.Add(center + ((right - up) * 0.5f), normal, new Vector2(1f, 0f));
            shape.Quad(a, b, c, d);
        }

        return shape.Build();
    }

    /// <summary>121 vertices, facing up.</summary>
    private static Mesh Plane()
    {
        var shape = new ShapeBuilder();
        shape.Grid(10, 10, (r, c) => (new Vector3(c - 5f, 0f, r - 5f), Vector3.up, new Vector2(1f - (c / 10f), 1f - (r / 10f))));
        return shape.Build();
    }

    /// <summary>Faces -z, as Unity's.</summary>
    private static Mesh Quad()
    {
        var shape = new ShapeBuilder();
        shape.Grid(1, 1, (r, c) => (new Vector3(c - 0.5f, r - 0.5f, 0f), Vector3.back, new Vector2(c, r)));
        return shape.Build();
    }

    /// <summary>A sphere whose halves are moved apart by twice the given length.</summary>
    private static Mesh Round(float halfLength, int rings)
    {
        var shape = new ShapeBuilder();

        // The equator is there twice where the halves are apart.
        int rows = halfLength > 0f ? rings + 1 : rings;
        shape.Grid(rows, Around, (r, c) =>
        {
            int ring = halfLength > 0f && r > rings / 2 ? r - 1 : r;
            float polar = Mathf.PI * ring / rings;
            float azimuth = 2f * Mathf.PI * c / Around;
            var normal = new Vector3(Mathf.Sin(polar) * Mathf.Cos(azimuth), -Mathf.Cos(polar), Mathf.Sin(polar) * Mathf.Sin(azimuth));
            float shift = halfLength > 0f ? (r > rings / 2 ? halfLength : -halfLength) : 0f;
            Vector3 position = (normal * Radius) + new Vector3(0f, shift, 0f);
            return (position, normal, new Vector2(c / (float)Around, (position.y + Radius + halfLength) / (2f * (Radius + halfLength))));
        });
        return shape.Build();
    }

    private static Mesh Cylinder()
    {
        var shape = new ShapeBuilder();
        shape.Grid(1, Around, (r, c) =>
        {
            float azimuth = 2f * Mathf.PI * c / Around;
            var normal = new Vector3(Mathf.Cos(azimuth), 0f, Mathf.Sin(azimuth));
            return ((normal * Radius) + new Vector3(0f, (2f * r) - 1f, 0f), normal, new Vector2(c / (float)Around, r));
        });
        Cap(shape, 1f);
        Cap(shape, -1f);
        return shape.Build();
    }

    private static void Cap(ShapeBuilder shape, float y)
    {
        var normal = new Vector3(0f, y, 0f);
        int center = shape.Add(normal, normal, new Vector2(0.5f, 0.5f));
        int first = center + 1;
        for (int c = 0; c < Around; c++)
        {
            float azimuth = 2f * Mathf.PI * c / Around;
            (float x, float z) = (Mathf.Cos(azimuth), Mathf.Sin(azimuth));
            shape.Add(new Vector3(x * Radius, y, z * Radius), normal, new Vector2(0.5f + (x * 0.5f), 0.5f + (z * 0.5f)));
        }

        for (int c = 0; c < Around; c++)
        {
            int next = first + ((c + 1) % Around);
            if (y > 0f)
            {
                shape.Triangle(center, next, first + c);
            }
            else
            {
                shape.Triangle(center, first + c, next);
            }
        }
    }
}
