using Headless.Shaders;
using UnityEngine;

namespace Headless.Importers.Assets;

internal sealed class ComputeImporter(IncludeResolver includes) : IAssetImporter
{
    private const long MainId = 7200000;

    public void Import(AssetFile file) =>
        file.Result.AddMain(MainId, new ComputeShader(ComputeSource.Parse(file.File, includes)) { name = file.Name });
}
