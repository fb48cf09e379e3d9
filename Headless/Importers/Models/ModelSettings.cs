using Headless.Importers.Project;
using Headless.Importers.Yaml;

namespace Headless.Importers.Models;

/// <summary>What a ModelImporter .meta says about a mesh. <c>isReadable</c> stands under <c>animations</c> there, although it concerns the mesh.</summary>
public sealed record ModelSettings
{
    public float Scale { get; init; } = 1;
    public bool IsReadable { get; init; }
    public bool WeldVertices { get; init; } = true;
    public ModelNormals Normals { get; init; } = ModelNormals.Import;
    public float SmoothingAngle { get; init; } = 60;

    public static ModelSettings From(MetaFile meta)
    {
        YamlMap meshes = meta.Settings.Map("meshes") ?? new YamlMap();
        YamlMap tangents = meta.Settings.Map("tangentSpace") ?? new YamlMap();
        bool readable = meta.Settings.Map("animations")?.Bool("isReadable") ?? false;
        int normals = tangents.Int("normalImportMode");
        if (normals is < 0 or > 2) throw new ImportException($"{meta.Path}: normalImportMode {normals} is not 0 (import), 1 (calculate) or 2 (none).");
        return new ModelSettings
        {
            Scale = meshes.Float("globalScale", 1),
            IsReadable = meta.Settings.Bool("isReadable", readable),
            WeldVertices = meshes.Bool("weldVertices", true),
            Normals = (ModelNormals)normals,
            SmoothingAngle = tangents.Float("normalSmoothAngle", 60),
        };
    }
}
