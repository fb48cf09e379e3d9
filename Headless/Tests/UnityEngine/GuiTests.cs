using Headless.Engine;
using NUnit.Framework;
using UnityEngine;

namespace Headless.Tests.UnityEngineApi;

/// <summary>OnGUI: when it is called, and what of it is seen on the screen.</summary>
public class GuiTests : EngineFixture
{
    const int Width = 40, Height = 30;

    [Test]
    public void OnGUIIsCalledToLayOutAndToPaintAfterLateUpdate()
    {
        GuiProbe probe = GuiProbe.Create();
        Frame();
        Assert.That(Take(), Is.EqualTo("Layout Repaint"));
        probe.useGUILayout = false;
        Frame();
        Assert.That(Take(), Is.EqualTo("Repaint"));
        probe.enabled = false;
        Frame();
        Assert.That(Take(), Is.Empty);
        Assert.That(Event.current, Is.Null);
    }

    [Test]
    public void TextIsWrittenInTheStylesColourAndStaysInItsRectangle()
    {
        var style = new GUIStyle { fontSize = 13, normal = { textColor = new Color(0f, 1f, 0f) } };
        GuiProbe.Create().OnPaint = () => GUI.Label(new Rect(7f, 2f, 14f, 13f), "-|-\n-", style);
        byte[] pixels = Painted(0);
        int dash = Enumerable.Range(0, Height).Single(y => At(pixels, 10, y)[1] == 255);
        Assert.That(dash, Is.InRange(6, 11), "a dash is one row in the middle of a line");
        Assert.That(At(pixels, 10, dash), Is.EqualTo(new[] { 0, 255, 0 }));
        Assert.That(Enumerable.Range(0, Height).Count(y => Enumerable.Range(14, 7).Any(x => At(pixels, x, y)[1] > 0)), Is.GreaterThan(8), "a bar is high");
        Assert.That(Enumerable.Range(21, Width - 21).Any(x => At(pixels, x, dash)[1] > 0), Is.False, "the second dash is outside");
        Assert.That(Enumerable.Range(15, Height - 15).Any(y => At(pixels, 10, y)[1] > 0), Is.False, "so is the second line");
    }

    [Test]
    public void ATextsSizeGrowsWithItsLettersAndLines()
    {
        var style = new GUIStyle { fontSize = 13 };
        Assert.That(style.CalcSize(new GUIContent("abc")), Is.EqualTo(new Vector2(21f, 13f)));
        Assert.That(style.CalcSize(new GUIContent("abc\nlonger")), Is.EqualTo(new Vector2(42f, 26f)));
        style.fontSize = 26;
        Assert.That(style.CalcSize(new GUIContent("abc")), Is.EqualTo(new Vector2(42f, 26f)));
    }

    [Test]
    public void NothingIsPaintedOutsideOnGUI()
    {
        GuiProbe.Create();
        GUI.Label(new Rect(0f, 0f, 40f, 30f), "text");
        Assert.That(Painted(9), Is.All.EqualTo((byte)9));
    }

    static byte[] Painted(byte before)
    {
        Frame();
        byte[] pixels = new byte[4 * Width * Height];
        pixels.AsSpan().Fill(before);
        GuiPicture.OfFrame().Paint(pixels, Width, Height);
        return pixels;
    }

    static int[] At(byte[] pixels, int x, int y) => [pixels[4 * (y * Width + x)], pixels[4 * (y * Width + x) + 1], pixels[4 * (y * Width + x) + 2]];
}
