using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using System;
using Headless.Shaders;
using UnityEngine;

namespace Headless.Engine;

/// <summary>Shaders by name: those that were imported and the built-in ones, which are parsed when first asked for.</summary>
internal static class ShaderLibrary
{
    private static readonly Dictionary<string, Shader> Shaders = new(StringComparer.Ordinal);

    // Shader names of the embedded files; several names may share one stand-in.
    private static readonly Dictionary<string, string> Builtin = new(StringComparer.Ordinal)
    {
        ["Standard"] = "Standard.shader",
        ["Standard (Specular setup)"] = "StandardSpecular.shader",
        ["Legacy Shaders/Diffuse"] = "Diffuse.shader",
        ["Diffuse"] = "Diffuse.shader",
        ["Unlit/Color"] = "UnlitColor.shader",
        ["Unlit/Texture"] = "UnlitTexture.shader",
        ["Unlit/Transparent"] = "UnlitTransparent.shader",
        ["Sprites/Default"] = "SpritesDefault.shader",
        ["Hidden/BlitCopy"] = "BlitCopy.shader",
        ["Skybox/Procedural"] = "Skybox.shader",
        ["Hidden/InternalErrorShader"] = "Error.shader",
        ["VertexLit"] = "Diffuse.shader",
        ["Legacy Shaders/VertexLit"] = "Diffuse.shader",
    };

    private static readonly Dictionary<string, Assembly> Brought = new(StringComparer.Ordinal);
    private static readonly Dictionary<string, Shader> BuiltinFiles = new(StringComparer.Ordinal);

    public static IReadOnlyCollection<Shader> All => Shaders.Values;

    /// <summary>Asked for a name that is not loaded yet; the importer looks in the project.</summary>
    public static Func<string, Shader?>? Resolver { get; set; }

    /// <summary>A shader that an assembly of Unity's packages holds as a resource.</summary>
    public static void AddBuiltin(Assembly assembly, string name, string file) => (Builtin[name], Brought[file]) = (file, assembly);

    public static void Add(Shader shader) => Shaders[shader.name] = shader;

    public static Shader? Find(string name)
    {
        if (Shaders.TryGetValue(name, out Shader? shader) && shader != null)
        {
            return shader;
        }

        return Resolver?.Invoke(name) ?? FindBuiltin(name);
    }

    public static Shader Require(string name) =>
        FindBuiltin(name) ?? throw new InvalidOperationException($"The built-in shader '{name}' is missing from the engine.");

    public static void Reset()
    {
        Shaders.Clear();
        BuiltinFiles.Clear();
        Resolver = null;
    }

    private static Shader? FindBuiltin(string name)
    {
        if (!Builtin.TryGetValue(name, out string? file))
        {
            return null;
        }

        if (!BuiltinFiles.TryGetValue(file, out Shader? shader) || shader == null)
        {
            Assembly assembly = Brought.GetValueOrDefault(file, typeof(ShaderLibrary).Assembly);
            string resource = assembly.GetManifestResourceNames().Single(n => n.EndsWith("." + file, StringComparison.Ordinal));
            using var reader = new StreamReader(assembly.GetManifestResourceStream(resource)!);
            ShaderLabSource source = ShaderLabSource.ParseText(file, reader.ReadToEnd(), GraphicsDevice.Compiler.Includes);
            shader = new Shader(source) { hideFlags = HideFlags.NotEditable };
            BuiltinFiles[file] = shader;
        }

        return shader;
    }
}
