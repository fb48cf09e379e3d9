using UnityEngine;

namespace Headless.Importers.Assets;

internal sealed class TextImporter : IAssetImporter
{
    private const long MainId = 4900000;

    public void Import(AssetFile file) => file.Result.AddMain(MainId, new TextAsset(File.ReadAllBytes(file.File)) { name = file.Name });
}
