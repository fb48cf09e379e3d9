using System.Collections.Generic;
using Headless.Vulkan;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;
using UnityEngine;

namespace Headless.Engine;

/// <summary>The textures that stand in where none is set, by the names that ShaderLab gives them.</summary>
internal static class DefaultTextures
{
    private static readonly Dictionary<string, Texture2D> Made = [];
    private static readonly Dictionary<GpuTextureDimension, GpuTexture> Shapes = [];

    public static Texture2D White => Get("UnityWhite", Color.white);
    public static Texture2D Black => Get("UnityBlack", new Color(0f, 0f, 0f, 0f));
    public static Texture2D Red => Get("UnityRed", Color.red);
    public static Texture2D Gray => Get("UnityGrey", new Color(0.5f, 0.5f, 0.5f, 0.5f), GraphicsFormat.R8G8B8A8_SRGB);
    public static Texture2D LinearGray => Get("UnityLinearGrey", new Color(0.5f, 0.5f, 0.5f, 0.5f));
    public static Texture2D Normal => Get("UnityNormal", new Color(0.5f, 0.5f, 1f, 0.5f));

    public static Texture2D Named(string name) => name switch
    {
        "white" => White,
        "black" => Black,
        "red" => Red,
        "bump" => Normal,
        "lineargray" or "lineargrey" => LinearGray,
        _ => Gray,
    };

    /// <summary>A black texture of the shape that the shader declares.</summary>
    public static GpuTexture Empty(string dimension)
    {
        GpuTextureDimension shape = dimension switch
        {
            "3D" => GpuTextureDimension.Texture3D,
            "Cube" => GpuTextureDimension.Cube,
            "2DArray" => GpuTextureDimension.Texture2DArray,
            _ => GpuTextureDimension.Texture2D,
        };
        if (shape == GpuTextureDimension.Texture2D)
        {
            return Gray.DeviceTexture(RenderTextureSubElement.Default)!;
        }

        if (!Shapes.TryGetValue(shape, out GpuTexture? texture))
        {
            texture = GraphicsDevice.Device.CreateTexture(
                new GpuTextureDescription
                {
                    Width = 1,
                    Height = 1,
                    Format = GpuFormat.R8G8B8A8Unorm,
                    Dimension = shape,
                    Layers = shape == GpuTextureDimension.Cube ? 6 : 1,
                },
                $"UnityBlack{dimension}");
            Shapes.Add(shape, texture);
        }

        return texture;
    }

    /// <summary>Forgets textures of a device that is gone.</summary>
    public static void Reset()
    {
        Made.Clear();
        Shapes.Clear();
    }

    private static Texture2D Get(string name, Color color, GraphicsFormat format = GraphicsFormat.R8G8B8A8_UNorm)
    {
        if (!Made.TryGetValue(name, out Texture2D? texture) || texture == null)
        {
            texture = new Texture2D(4, 4, format, TextureCreationFlags.None) { name = name, hideFlags = HideFlags.HideAndDontSave };
            texture.Pixels.Fill(color);
            texture.Apply(false, true);
            Made[name] = texture;
        }

        return texture;
    }
}
