using System.Globalization;
using UnityEngine.Rendering;
using UnityEngine;

namespace Headless.Engine;

/// <summary>Reads Queue tags such as "Transparent-10".</summary>
internal static class QueueParser
{
    public static int Parse(string tag, string shader)
    {
        if (tag.Length == 0)
        {
            return (int)RenderQueue.Geometry;
        }

        int sign = tag.IndexOfAny(['+', '-'], 1);
        string name = (sign < 0 ? tag : tag[..sign]).Trim();
        int offset = 0;
        bool numberRead = sign < 0 || int.TryParse(tag[sign..].Replace(" ", string.Empty), NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out offset);
        int? start = name.ToLowerInvariant() switch
        {
            "background" => 1000,
            "geometry" => 2000,
            "alphatest" => 2450,
            "geometrylast" => 2500,
            "transparent" => 3000,
            "overlay" => 4000,
            _ => int.TryParse(name, NumberStyles.None, CultureInfo.InvariantCulture, out int plain) ? plain : null,
        };
        if (start is null || !numberRead)
        {
            Debug.LogError($"Shader '{shader}': the Queue tag '{tag}' is none of Background, Geometry, AlphaTest, Transparent, Overlay with an offset.");
        }

        return (start ?? (int)RenderQueue.Geometry) + offset;
    }
}
