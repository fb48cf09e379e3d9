using Headless.Engine;
using Headless.Tests.UnityEngineApi;
using NUnit.Framework;
using UnityEngine;

namespace Headless.Tests.Rendering;

/// <summary>What OnGUI painted is over the picture of its frame, and of no other.</summary>
public sealed class GuiPictureTests : RenderFixture
{
    [Test]
    public void ARectangleIsBlendedOverTheScreen()
    {
        GuiProbe probe = GuiProbe.Create();
        probe.OnPaint = () =>
            GUI.DrawTexture(new Rect(2f, 3f, 4f, 5f), Texture2D.whiteTexture, ScaleMode.StretchToFill, true, 0f, new Color(1f, 0f, 0f, 0.5f), 0f, 0f);
        PlayerLoop.RunFrame();
        var readback = new ScreenReadback();
        readback.Capture(0);
        probe.enabled = false;
        PlayerLoop.RunFrame();
        readback.Capture(1);

        Assert.That(readback.TryTake(true, out CapturedFrame painted), Is.True);
        Assert.That(readback.TryTake(true, out CapturedFrame plain), Is.True);
        for (int y = 0; y < plain.Height; y++)
            for (int x = 0; x < plain.Width; x++)
            {
                bool inside = x is >= 2 and < 6 && y is >= 3 and < 8;
                int red = At(plain, x, y, 0), green = At(plain, x, y, 1);
                Assert.That(At(painted, x, y, 0), Is.EqualTo(inside ? (int)MathF.Round(0.5f * (red + 255f)) : red).Within(1), $"red of {x}, {y}");
                Assert.That(At(painted, x, y, 1), Is.EqualTo(inside ? (int)MathF.Round(0.5f * green) : green).Within(1), $"green of {x}, {y}");
            }
        Assert.That(At(painted, 2, 3, 0), Is.Not.EqualTo(At(plain, 2, 3, 0)));
    }

    private static int At(in CapturedFrame frame, int x, int y, int channel) => frame.Pixels[4 * (y * frame.Width + x) + channel];
}
