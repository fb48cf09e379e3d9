using System.Numerics;
using Headless.Importers.Models;
using NUnit.Framework;

namespace Headless.Tests.Importers;

public sealed class PolygonTriangulatorTests
{
    private static float SignedArea(IReadOnlyList<Vector3> corners, IReadOnlyList<int> triangles)
    {
        float sum = 0;
        for (int i = 0; i < triangles.Count; i += 3)
            sum += Vector3.Cross(corners[triangles[i + 1]] - corners[triangles[i]], corners[triangles[i + 2]] - corners[triangles[i]]).Z / 2;
        return sum;
    }

    [Test]
    public void AConvexPolygonIsAFan()
    {
        Vector3[] hexagon = [.. Enumerable.Range(0, 6).Select(i => new Vector3(MathF.Cos(i * MathF.PI / 3), MathF.Sin(i * MathF.PI / 3), 0))];
        List<int> triangles = PolygonTriangulator.Triangulate(hexagon);
        Assert.That(triangles, Has.Count.EqualTo(12));
        Assert.That(SignedArea(hexagon, triangles), Is.EqualTo(1.5f * MathF.Sqrt(3)).Within(1e-5));
    }

    [Test]
    public void AConcavePolygonIsCoveredOnceWithTheSameWinding([Range(0, 3)] int start)
    {
        Vector3[] arrow = [new(-1, 0, 0), new(1, -1, 0), new(0.4f, 0, 0), new(1, 1, 0)];
        Vector3[] turned = [.. Enumerable.Range(0, 4).Select(i => arrow[(i + start) % 4])];
        List<int> triangles = PolygonTriangulator.Triangulate(turned);
        Assert.That(SignedArea(turned, triangles), Is.EqualTo(1.4f).Within(1e-5));
        for (int i = 0; i < triangles.Count; i += 3) Assert.That(SignedArea(turned, triangles.GetRange(i, 3)), Is.GreaterThan(0));
    }
}
