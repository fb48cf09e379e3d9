using Headless.Shaders;
using UnityEngine;

namespace Headless.Importers.Assets;

internal sealed class ShaderImporter(IncludeResolver includes) : IAssetImporter
{
    private const long MainId = 4800000;

    public void Import(AssetFile file) => file.Result.AddMain(MainId, new Shader(ShaderLabSource.Parse(file.File, includes)));
}
