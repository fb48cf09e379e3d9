using Headless.Files;
using UnityEngine;

namespace Headless.Importers.Assets;

internal sealed class TextImporter : IAssetImporter
{
    private const long MainId = 4900000;

    public void Import(AssetFile file) => file.Result.AddMain(MainId, new TextAsset(BoundedText.ReadBytes(file.File)) { name = file.Name });
}
