using System.Collections.Generic;
using System.IO;
using System.Linq;
using System;
using UnityEngine;

namespace Headless.Engine;

/// <summary>The engine's own meshes, materials and shaders by name.</summary>
internal static class BuiltinResources
{
    private static readonly Dictionary<string, Material> Materials = new(StringComparer.Ordinal);

    private static readonly string[] MaterialNames =
        ["Default-Material", "Default-Diffuse", "Default-Skybox", "Default-Line", "Default-Particle", "Sprites-Default"];

    public static Material DefaultMaterial => Material("Default-Material");

    public static Material DefaultSkybox => Material("Default-Skybox");

    /// <summary>Resources.GetBuiltinResource: "Cube.fbx", "Default-Material.mat"...; null for a name that is not there.</summary>
    public static UnityEngine.Object? Find(Type type, string name)
    {
        string plain = Path.GetFileNameWithoutExtension(name);
        if (type == typeof(Mesh))
        {
            return Enum.TryParse(plain.Replace("New-", string.Empty), out PrimitiveType shape) ? BuiltinMeshes.Get(shape) : null;
        }

        if (type == typeof(Material))
        {
            return MaterialNames.Contains(plain) ? Material(plain) : null;
        }

        return type == typeof(Shader) ? Shader.Find(plain) : null;
    }

    public static void Reset() => Materials.Clear();

    private static Material Material(string name)
    {
        if (!Materials.TryGetValue(name, out Material? material) || material == null)
        {
            string shader = name switch
            {
                "Default-Skybox" => "Skybox/Procedural",
                "Default-Diffuse" => "Legacy Shaders/Diffuse",
                "Sprites-Default" or "Default-Line" or "Default-Particle" => "Sprites/Default",
                _ => "Standard",
            };
            material = new Material(Shader.Find(shader)!) { name = name, hideFlags = HideFlags.NotEditable, IsPersistent = true };
            Materials[name] = material;
        }

        return material;
    }
}
