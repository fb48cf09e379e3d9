using Headless.Files;
using Headless.Importers.Yaml;
using UnityEngine;

namespace Headless.Importers.Assets;

/// <summary>PNG and JPEG textures with the settings that change a picture: colour space, mip maps, filter, wrap.</summary>
internal sealed class ImageImporter : IAssetImporter
{
    private const long MainId = 2800000;
    private const int FlatShape = 1;
    private const int LargestFile = 256 << 20;

    public void Import(AssetFile file)
    {
        YamlMap mipmaps = file.Meta.Settings.Map("mipmaps") ?? new YamlMap(), sampling = file.Meta.Settings.Map("textureSettings") ?? new YamlMap();
        if (file.Meta.Settings.Int("textureShape", FlatShape) != FlatShape)
            file.Project.Report($"{file.AssetPath}: cubemaps and layers made of a picture are not read here; it is a flat texture.");
        bool linear = !mipmaps.Bool("sRGBTexture", true);
        var texture = new Texture2D(2, 2, TextureFormat.RGBA32, mipmaps.Bool("enableMipMap", true), linear) { name = file.Name };
        if (!texture.LoadImage(BoundedText.ReadBytes(file.File, LargestFile), !file.Meta.Settings.Bool("isReadable")))
            throw new ImportException($"{file.AssetPath}: not a picture that can be read here; PNG is. Save it as PNG.");
        // -1 in the .meta means the default: bilinear, repeat.
        int filter = sampling.Int("filterMode", 1), wrapU = sampling.Int("wrapU"), wrapV = sampling.Int("wrapV");
        texture.filterMode = filter < 0 ? FilterMode.Bilinear : (FilterMode)filter;
        texture.wrapModeU = wrapU < 0 ? TextureWrapMode.Repeat : (TextureWrapMode)wrapU;
        texture.wrapModeV = wrapV < 0 ? TextureWrapMode.Repeat : (TextureWrapMode)wrapV;
        file.Result.AddMain(MainId, texture);
    }
}
