using System.Numerics;

namespace Headless.Importers.Models;

/// <summary>
/// One group of an .obj file as Unity's importer makes it: x negated and the winding flipped (right- to left-handed),
/// polygons triangulated, equal vertices welded, one submesh a material.
/// </summary>
public static class ObjGeometryBuilder
{
    private readonly record struct Vertex(Vector3 Position, Vector3 Normal, Vector2 TextureCoordinate);

    public static MeshGeometry Build(ObjFile file, ObjGroup group, ModelSettings settings)
    {
        var corners = new List<(ObjCorner Corner, int SubMesh)>();
        var materials = new Dictionary<string, int>(StringComparer.Ordinal);
        foreach (ObjFace face in group.Faces)
        {
            if (!materials.TryGetValue(face.Material, out int subMesh)) materials[face.Material] = subMesh = materials.Count;
            List<int> triangles = PolygonTriangulator.Triangulate(Array.ConvertAll(face.Corners, c => file.Positions[c.Position]), ref file.TriangulationWork);
            for (int i = 0; i < triangles.Count; i += 3)
                foreach (int at in (ReadOnlySpan<int>)[triangles[i], triangles[i + 2], triangles[i + 1]])
                    corners.Add((face.Corners[at], subMesh));
        }

        Vector3[] positions = corners.Select(c => Mirror(file.Positions[c.Corner.Position]) * settings.Scale).ToArray();
        Vector3[]? normals = Normals(file, corners, positions, settings);
        bool hasCoordinates = corners.Exists(c => c.Corner.TextureCoordinate >= 0);

        var geometry = new MeshGeometry();
        for (int i = 0; i < materials.Count; i++) geometry.SubMeshes.Add([]);
        var known = new Dictionary<Vertex, int>();
        for (int i = 0; i < corners.Count; i++)
        {
            int coordinate = corners[i].Corner.TextureCoordinate;
            var vertex = new Vertex(positions[i], normals?[i] ?? default, coordinate >= 0 ? file.TextureCoordinates[coordinate] : default);
            if (!settings.WeldVertices || !known.TryGetValue(vertex, out int index))
            {
                index = geometry.Vertices.Count;
                known[vertex] = index;
                geometry.Vertices.Add(vertex.Position);
                if (normals is not null) geometry.Normals.Add(vertex.Normal);
                if (hasCoordinates) geometry.TextureCoordinates.Add(vertex.TextureCoordinate);
            }
            geometry.SubMeshes[corners[i].SubMesh].Add(index);
        }
        return geometry;
    }

    private static Vector3[]? Normals(ObjFile file, List<(ObjCorner Corner, int SubMesh)> corners, Vector3[] positions, ModelSettings settings)
    {
        if (settings.Normals == ModelNormals.None) return null;
        if (settings.Normals == ModelNormals.Import && corners.TrueForAll(c => c.Corner.Normal >= 0))
            return corners.Select(c => Vector3.Normalize(Mirror(file.Normals[c.Corner.Normal]))).ToArray();
        // Clockwise is front in Unity's left-handed space: cross products of mirrored, flipped corners already point outwards.
        return SmoothNormals.Compute(positions, settings.SmoothingAngle);
    }

    private static Vector3 Mirror(Vector3 v) => new(-v.X, v.Y, v.Z);
}
