using Headless.Importers.Models;
using Headless.Importers.Scenes;
using UnityEngine;
using UnityEngine.Rendering;

namespace Headless.Importers.Assets;

internal sealed class ObjImporter : IAssetImporter
{
    public void Import(AssetFile file)
    {
        ObjFile model = ObjFile.Read(file.File);
        ModelSettings settings = ModelSettings.From(file.Meta);
        foreach (ObjGroup group in model.Groups)
            file.Result.Add(ModelPrefab.MeshId(group.Name), CreateMesh(group.Name, Geometry(file, model, group, settings), settings));
        file.Result.AddLater(() => PrefabImporter.Build(file, ModelPrefab.Documents(file.Name, file.Result.Guid, model.Groups.Select(g => g.Name)), ModelPrefab.RootTransform));
    }

    private static MeshGeometry Geometry(AssetFile file, ObjFile model, ObjGroup group, ModelSettings settings)
    {
        try
        {
            return ObjGeometryBuilder.Build(model, group, settings);
        }
        catch (FormatException e)
        {
            throw new ImportException($"{file.AssetPath}: {e.Message}", e);
        }
    }

    private static Mesh CreateMesh(string name, MeshGeometry geometry, ModelSettings settings)
    {
        var mesh = new Mesh { name = name };
        if (geometry.Vertices.Count > ushort.MaxValue) mesh.indexFormat = IndexFormat.UInt32;
        mesh.SetVertices(geometry.Vertices.ConvertAll(v => new Vector3(v.X, v.Y, v.Z)));
        if (geometry.Normals.Count > 0) mesh.SetNormals(geometry.Normals.ConvertAll(v => new Vector3(v.X, v.Y, v.Z)));
        if (geometry.TextureCoordinates.Count > 0) mesh.SetUVs(0, geometry.TextureCoordinates.ConvertAll(v => new Vector2(v.X, v.Y)));
        mesh.subMeshCount = geometry.SubMeshes.Count;
        for (int i = 0; i < geometry.SubMeshes.Count; i++) mesh.SetTriangles(geometry.SubMeshes[i], i, false);
        mesh.RecalculateBounds();
        if (geometry.Normals.Count > 0 && geometry.TextureCoordinates.Count > 0) mesh.RecalculateTangents();
        if (!settings.IsReadable) mesh.UploadMeshData(true);
        return mesh;
    }
}
