using Headless.Importers.Project;

namespace Headless.Importers.Assets;

/// <summary>What an importer works on: the file, its settings, the place for its results.</summary>
public sealed record AssetFile(ProjectAssets Project, string AssetPath, string File, MetaFile Meta, ImportedAsset Result)
{
    public string Name => Path.GetFileNameWithoutExtension(AssetPath);
}
