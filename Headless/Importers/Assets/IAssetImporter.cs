namespace Headless.Importers.Assets;

internal interface IAssetImporter
{
    void Import(AssetFile file);
}
