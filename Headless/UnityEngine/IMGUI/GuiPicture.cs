using System;
using System.Collections.Generic;
using UnityEngine;

namespace Headless.Engine;

/// <summary>What scripts painted by OnGUI in this frame, and how it looks: flat rectangles and text, over a picture of the screen.</summary>
sealed class GuiPicture
{
    readonly record struct Item(Rect Place, string? Text, int FontSize, Color Color);

    static readonly List<Item> s_Items = new();

    readonly Item[] m_Items;

    GuiPicture(Item[] items) => m_Items = items;

    /// <summary>What this frame has by now.</summary>
    public static GuiPicture OfFrame() => new(s_Items.ToArray());

    public static void Clear() => s_Items.Clear();

    public static void Add(Rect place, Color color)
    {
        if (IsPainting) s_Items.Add(new Item(place, null, 0, color * GUI.color));
    }

    public static void Add(Rect place, string text, GUIStyle style)
    {
        if (IsPainting && !string.IsNullOrEmpty(text)) s_Items.Add(new Item(place, text, style.fontSize, style.normal.textColor * GUI.color * GUI.contentColor));
    }

    static bool IsPainting => Event.current is { type: EventType.Repaint };

    /// <summary>Paints over a picture of the screen, in its bytes as a display takes them.</summary>
    /// <param name="pixels">RGBA, 8 bits each, the top row first.</param>
    /// <param name="width">Pixels of a row.</param>
    /// <param name="height">Rows.</param>
    public void Paint(Span<byte> pixels, int width, int height)
    {
        foreach (Item item in m_Items)
        {
            if (item.Text is null) Fill(pixels, width, height, item.Place, item.Color);
            else Write(pixels, width, height, item);
        }
    }

    static void Fill(Span<byte> pixels, int width, int height, Rect place, Color color)
    {
        int left = Math.Max(0, (int)MathF.Round(place.xMin)), right = Math.Min(width, (int)MathF.Round(place.xMax));
        int top = Math.Max(0, (int)MathF.Round(place.yMin)), bottom = Math.Min(height, (int)MathF.Round(place.yMax));
        for (int y = top; y < bottom; y++)
            for (int x = left; x < right; x++) Blend(pixels.Slice(4 * (y * width + x), 4), color, color.a);
    }

    static void Write(Span<byte> pixels, int width, int height, in Item item)
    {
        float scale = GuiFont.Scale(item.FontSize);
        int left = (int)MathF.Floor(item.Place.xMin), top = (int)MathF.Floor(item.Place.yMin);
        string[] lines = item.Text!.Split('\n');
        for (int y = Math.Max(0, top); y < Math.Min(height, (int)MathF.Ceiling(item.Place.yMax)); y++)
        {
            float row = (y + 0.5f - top) / scale;
            int line = (int)(row / GuiFont.Height);
            if (line >= lines.Length) return;
            for (int x = Math.Max(0, left); x < Math.Min(width, (int)MathF.Ceiling(item.Place.xMax)); x++)
            {
                float column = (x + 0.5f - left) / scale;
                int letter = (int)(column / GuiFont.Width);
                if (letter >= lines[line].Length) break;
                float cover = GuiFont.Cover(lines[line][letter], column - letter * GuiFont.Width, row - line * GuiFont.Height, scale);
                if (cover > 0f) Blend(pixels.Slice(4 * (y * width + x), 4), item.Color, cover * item.Color.a);
            }
        }
    }

    static void Blend(Span<byte> pixel, Color color, float part)
    {
        for (int c = 0; c < 3; c++) pixel[c] = (byte)MathF.Round(Mathf.Lerp(pixel[c], 255f * Mathf.Clamp01(color[c]), Mathf.Clamp01(part)));
    }
}
