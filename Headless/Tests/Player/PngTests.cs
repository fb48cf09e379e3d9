using System.Diagnostics;
using Headless.Player.Output;
using NUnit.Framework;

namespace Headless.Tests.Player;

public sealed class PngTests
{
    private static byte[] Encode(int width, int height, byte[] rgba)
    {
        var stream = new MemoryStream();
        Png.Write(stream, width, height, rgba);
        return stream.ToArray();
    }

    [TestCase(1, 1)]
    [TestCase(37, 5)]
    [TestCase(64, 64)]
    public void PixelsSurvive(int width, int height)
    {
        byte[] rgba = new byte[width * height * 4];
        new Random(7).NextBytes(rgba);
        Picture picture = Picture.Read(Encode(width, height, rgba));
        Assert.That((picture.Width, picture.Height), Is.EqualTo((width, height)));
        for (int y = 0; y < height; y++)
            for (int x = 0; x < width; x++)
            {
                int at = 4 * (y * width + x);
                Assert.That(picture[x, y], Is.EqualTo(((int)rgba[at], (int)rgba[at + 1], (int)rgba[at + 2])));
            }
    }

    [Test]
    public void ChecksumsAreThoseOfTheStandard()
    {
        // ISO/IEC 15948: the CRC of an empty IEND chunk is AE 42 60 82.
        Assert.That(Encode(1, 1, new byte[4])[^4..], Is.EqualTo(new byte[] { 0xAE, 0x42, 0x60, 0x82 }));
    }

    [Test]
    public void AnotherProgramReadsThem()
    {
        string file = Path.ChangeExtension(Path.GetTempFileName(), ".png");
        File.WriteAllBytes(file, Encode(33, 9, new byte[33 * 9 * 4]));
        try
        {
            using Process probe = Process.Start(new ProcessStartInfo("ffprobe", ["-v", "error", "-show_entries", "stream=width,height", "-of", "csv=p=0", file]) { RedirectStandardOutput = true })!;
            Assert.That(probe.StandardOutput.ReadToEnd().Trim(), Is.EqualTo("33,9"));
        }
        catch (System.ComponentModel.Win32Exception)
        {
            Assert.Ignore("ffprobe (Debian package ffmpeg) is not installed");
        }
        finally
        {
            File.Delete(file);
        }
    }
}
