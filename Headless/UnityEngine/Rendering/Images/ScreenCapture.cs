using System.IO;
using Headless.Engine;

namespace UnityEngine;

public static class ScreenCapture
{
    public static void CaptureScreenshot(string filename)
    {
        byte[] pixels = GraphicsDevice.Device.ReadTexture(ScreenTarget.Texture);
        GuiPicture.OfFrame().Paint(pixels, ScreenTarget.Width, ScreenTarget.Height);
        File.WriteAllBytes(filename, PngWriter.Encode(ScreenTarget.Width, ScreenTarget.Height, 4, pixels));
    }

    public static Texture2D CaptureScreenshotAsTexture()
    {
        var texture = new Texture2D(ScreenTarget.Width, ScreenTarget.Height, TextureFormat.RGBA32, false);
        RenderTexture? active = RenderTexture.active;
        RenderTexture.active = null;
        texture.ReadPixels(new Rect(0f, 0f, texture.width, texture.height), 0, 0, false);
        RenderTexture.active = active;
        texture.Apply(false);
        return texture;
    }
}
