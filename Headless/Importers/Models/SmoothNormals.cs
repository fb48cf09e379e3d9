using System.Numerics;

namespace Headless.Importers.Models;

/// <summary>
/// Vertex normals computed as Unity's AreaAndAngleWeighted mode: each corner takes the normals of the faces that join at
/// its position and turn by at most the smoothing angle, weighted by area and corner angle.
/// </summary>
public static class SmoothNormals
{
    private const double MostComparisons = 1e9;

    /// <param name="corners">Positions, three a triangle.</param>
    /// <returns>One unit normal a corner; for triangles without area the zero vector.</returns>
    public static Vector3[] Compute(IReadOnlyList<Vector3> corners, float smoothingAngleDegrees)
    {
        int count = corners.Count;
        var faceNormals = new Vector3[count / 3];
        var weights = new float[count];
        var meeting = new Dictionary<Vector3, List<int>>();
        for (int corner = 0; corner < count; corner++)
        {
            int face = corner / 3;
            Vector3 a = corners[corner], b = corners[face * 3 + (corner + 1) % 3], c = corners[face * 3 + (corner + 2) % 3];
            Vector3 cross = Vector3.Cross(b - a, c - a);
            float area = cross.Length();
            faceNormals[face] = area > 0 ? cross / area : Vector3.Zero;
            weights[corner] = area * Angle(b - a, c - a);
            if (!meeting.TryGetValue(a, out List<int>? list)) meeting[a] = list = [];
            list.Add(corner);
        }

        double comparisons = meeting.Values.Sum(m => (double)m.Count * m.Count);
        if (comparisons > MostComparisons)
        {
            var (at, most) = meeting.MaxBy(m => m.Value.Count);
            throw new FormatException(FormattableString.Invariant(
                $"{most.Count} corners of triangles lie at ({at.X}, {at.Y}, {at.Z}), too many to smooth normals over. Export the model with normals, or set Normals to None in its import settings."));
        }

        float limit = MathF.Cos(Math.Clamp(smoothingAngleDegrees, 0, 180) * MathF.PI / 180) - 1e-5f;
        var normals = new Vector3[count];
        for (int corner = 0; corner < count; corner++)
        {
            Vector3 own = faceNormals[corner / 3], sum = Vector3.Zero;
            foreach (int other in meeting[corners[corner]])
            {
                Vector3 normal = faceNormals[other / 3];
                if (other / 3 == corner / 3 || Vector3.Dot(normal, own) >= limit) sum += normal * weights[other];
            }
            float length = sum.Length();
            normals[corner] = length > 0 ? sum / length : own;
        }
        return normals;
    }

    private static float Angle(Vector3 a, Vector3 b)
    {
        float lengths = a.Length() * b.Length();
        return lengths > 0 ? MathF.Acos(Math.Clamp(Vector3.Dot(a, b) / lengths, -1, 1)) : 0;
    }
}
