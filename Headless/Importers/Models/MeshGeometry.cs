using System.Numerics;

namespace Headless.Importers.Models;

/// <summary>Triangles in Unity's left-handed space, clockwise seen from the front; one index list a submesh.</summary>
public sealed class MeshGeometry
{
    public List<Vector3> Vertices { get; } = [];
    public List<Vector3> Normals { get; } = [];
    public List<Vector2> TextureCoordinates { get; } = [];
    public List<List<int>> SubMeshes { get; } = [];
}
