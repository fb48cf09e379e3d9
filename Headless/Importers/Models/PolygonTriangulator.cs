using System.Numerics;

namespace Headless.Importers.Models;

/// <summary>Splits a planar polygon into triangles of the same winding: a fan when it is convex, ear clipping otherwise.</summary>
public static class PolygonTriangulator
{
    /// <returns>Triples of indices into <paramref name="corners"/>, 3 (n - 2) of them.</returns>
    public static List<int> Triangulate(IReadOnlyList<Vector3> corners)
    {
        int count = corners.Count;
        var triangles = new List<int>(3 * (count - 2));
        Vector3 normal = NewellNormal(corners);
        if (count == 3 || IsConvex(corners, normal))
        {
            for (int i = 1; i + 1 < count; i++) triangles.AddRange([0, i, i + 1]);
            return triangles;
        }
        List<int> left = [.. Enumerable.Range(0, count)];
        while (left.Count > 3)
        {
            int ear = FindEar(corners, left, normal);
            int n = left.Count;
            triangles.AddRange([left[(ear + n - 1) % n], left[ear], left[(ear + 1) % n]]);
            left.RemoveAt(ear);
        }
        triangles.AddRange(left);
        return triangles;
    }

    private static int FindEar(IReadOnlyList<Vector3> corners, List<int> left, Vector3 normal)
    {
        int n = left.Count;
        for (int i = 0; i < n; i++)
        {
            Vector3 a = corners[left[(i + n - 1) % n]], b = corners[left[i]], c = corners[left[(i + 1) % n]];
            if (Turn(a, b, c, normal) <= 0) continue;
            bool empty = true;
            for (int j = 2; j < n - 1 && empty; j++)
            {
                Vector3 p = corners[left[(i + j) % n]];
                empty = Turn(a, b, p, normal) < 0 || Turn(b, c, p, normal) < 0 || Turn(c, a, p, normal) < 0;
            }
            if (empty) return i;
        }
        return 0;
    }

    private static bool IsConvex(IReadOnlyList<Vector3> corners, Vector3 normal)
    {
        int n = corners.Count;
        for (int i = 0; i < n; i++)
            if (Turn(corners[i], corners[(i + 1) % n], corners[(i + 2) % n], normal) < 0) return false;
        return true;
    }

    private static float Turn(Vector3 a, Vector3 b, Vector3 c, Vector3 normal) => Vector3.Dot(Vector3.Cross(b - a, c - b), normal);

    private static Vector3 NewellNormal(IReadOnlyList<Vector3> corners)
    {
        Vector3 sum = Vector3.Zero;
        for (int i = 0; i < corners.Count; i++) sum += Vector3.Cross(corners[i] - corners[0], corners[(i + 1) % corners.Count] - corners[0]);
        return sum;
    }
}
