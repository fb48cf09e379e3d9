using System.Numerics;

namespace Headless.Importers.Models;

/// <summary>
/// Splits a planar polygon into triangles of the same winding: a fan when it is convex, ear clipping otherwise, whose work grows
/// as the corners times those that turn inwards.
/// </summary>
public static class PolygonTriangulator
{
    private const long MostWork = 100_000_000;

    /// <returns>Triples of indices into <paramref name="corners"/>, 3 (n - 2) of them.</returns>
    public static List<int> Triangulate(IReadOnlyList<Vector3> corners)
    {
        long work = 0;
        return Triangulate(corners, ref work);
    }

    /// <param name="work">Comparisons so far; those of this polygon are added before they are made.</param>
    /// <exception cref="FormatException">They come to more than a second's worth.</exception>
    public static List<int> Triangulate(IReadOnlyList<Vector3> corners, ref long work)
    {
        int count = corners.Count;
        var triangles = new List<int>(3 * (count - 2));
        Vector3 normal = NewellNormal(corners);
        if (count == 3 || IsConvex(corners, normal))
        {
            for (int i = 1; i + 1 < count; i++) triangles.AddRange([0, i, i + 1]);
            return triangles;
        }
        work += (long)count * count;
        if (work > MostWork)
            throw new FormatException("its concave faces have too many corners to be divided into triangles here. Triangulate them in the modelling program.");
        var left = new List<int>(Enumerable.Range(0, count));
        List<int> reflex = [.. left.Where(i => Turn(corners[(i + count - 1) % count], corners[i], corners[(i + 1) % count], normal) <= 0)];
        var ears = new HashSet<int>(left.Where((_, at) => IsEar(corners, left, at, reflex, normal)));
        while (left.Count > 3)
        {
            int n = left.Count;
            // Every simple polygon has an ear; of one that crosses itself any corner will do.
            int ear = Math.Max(0, left.FindIndex(ears.Contains));
            triangles.AddRange([left[(ear + n - 1) % n], left[ear], left[(ear + 1) % n]]);
            ears.Remove(left[ear]);
            reflex.Remove(left[ear]);
            left.RemoveAt(ear);
            Update((ear + n - 2) % (n - 1));
            Update(ear % (n - 1));
        }
        triangles.AddRange(left);
        return triangles;

        // Cutting off an ear changes its two neighbours only: what stood in a triangle is reflex, and an ear is not.
        void Update(int at)
        {
            int n = left.Count;
            if (Turn(corners[left[(at + n - 1) % n]], corners[left[at]], corners[left[(at + 1) % n]], normal) > 0) reflex.Remove(left[at]);
            if (IsEar(corners, left, at, reflex, normal)) ears.Add(left[at]);
            else ears.Remove(left[at]);
        }
    }

    private static bool IsEar(IReadOnlyList<Vector3> corners, List<int> left, int at, List<int> reflex, Vector3 normal)
    {
        int n = left.Count, before = left[(at + n - 1) % n], after = left[(at + 1) % n];
        Vector3 a = corners[before], b = corners[left[at]], c = corners[after];
        if (Turn(a, b, c, normal) <= 0) return false;
        foreach (int other in reflex)
        {
            if (other == before || other == after || other == left[at]) continue;
            Vector3 p = corners[other];
            if (!(Turn(a, b, p, normal) < 0 || Turn(b, c, p, normal) < 0 || Turn(c, a, p, normal) < 0)) return false;
        }
        return true;
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
