using Headless.Engine;
using Headless.Importers;
using Headless.Shaders;
using Headless.Tests.Rendering;
using NUnit.Framework;
using UnityEngine;

namespace Headless.Tests.Importers;

public sealed class ImageImporterTests : RenderFixture
{
    [TestCase(1, 0)]
    [TestCase(2, 1)]
    public void PicturesBecomeFlatTextures(int shape, int reportCount)
    {
        var reports = new List<string>();
        using var project = new TemporaryProject();
        project.Add("Assets/Sky.png", "", $"TextureImporter:\n  mipmaps:\n    enableMipMap: 0\n    sRGBTexture: 1\n  textureShape: {shape}\n");
        File.WriteAllBytes(Path.Combine(project.Root, "Assets/Sky.png"), PngWriter.Encode(2, 1, 4, [255, 0, 0, 255, 0, 255, 0, 255]));
        UnityProject opened = UnityProject.Open(project.Root, _ => null, new IncludeResolver(project.Root), reports.Add);
        var texture = (Texture2D)opened.Assets.LoadMain("Assets/Sky.png")!;
        Assert.That((texture.width, texture.height), Is.EqualTo((2, 1)));
        Assert.That(reports, Has.Count.EqualTo(reportCount).And.All.Contains("Assets/Sky.png"));
    }
}
