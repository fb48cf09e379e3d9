using Headless.Importers.Scenes;
using Headless.Importers.Serialization;
using Headless.Importers.Yaml;
using UnityEngine;
using UnityEngine.Rendering;

namespace Headless.Importers.Assets;

/// <summary>Materials: saved properties, keywords, queue, tags. A property that is not listed keeps the shader's default.</summary>
internal static class MaterialReader
{
    private const string ErrorShader = "Hidden/InternalErrorShader";

    public static Material Create(NativeFields f)
    {
        Shader shader = f.Reference<Shader>("m_Shader") ?? Shader.Find(ErrorShader)!;
        return new Material(shader);
    }

    public static void Fill(Material material, NativeFields f)
    {
        material.enableInstancing = f.Bool("m_EnableInstancingVariants");
        material.doubleSidedGI = f.Bool("m_DoubleSidedGI");
        int queue = f.Int("m_CustomRenderQueue", -1);
        if (queue >= 0) material.renderQueue = queue;
        foreach (string keyword in f.Map.Texts("m_ValidKeywords").Concat(f.Map.Texts("m_InvalidKeywords"))) material.EnableKeyword(keyword);
        // Before 2021.2 the keywords were one string.
        foreach (string keyword in f.Text("m_ShaderKeywords").Split(' ', StringSplitOptions.RemoveEmptyEntries)) material.EnableKeyword(keyword);
        if (f.Map.Map("stringTagMap") is { } tags)
            foreach (var (tag, _) in tags.Entries) material.SetOverrideTag(tag, tags.Text(tag));
        foreach (string pass in f.Map.Texts("disabledShaderPasses")) material.SetShaderPassEnabled(pass, false);

        NativeFields saved = f.Nested("m_SavedProperties");
        foreach (var (name, pair) in Pairs(saved, "m_Floats")) material.SetFloat(name, pair.Float(name));
        foreach (var (name, pair) in Pairs(saved, "m_Ints")) material.SetInteger(name, pair.Int(name));
        foreach (var (name, pair) in Pairs(saved, "m_Colors"))
            if (pair.Map(name) is { } colour) SetColor(material, name, colour);
        foreach (var (name, pair) in Pairs(saved, "m_TexEnvs"))
        {
            NativeFields texture = saved with { Map = pair.Map(name) ?? new YamlMap(pair.Place) };
            if (texture.Reference<Texture>("m_Texture") is { } found) material.SetTexture(name, found);
            if (material.HasProperty(name))
            {
                Vector3 scale = texture.Vector3("m_Scale", Vector3.one), offset = texture.Vector3("m_Offset");
                material.SetTextureScale(name, new Vector2(scale.x, scale.y));
                material.SetTextureOffset(name, new Vector2(offset.x, offset.y));
            }
        }
    }

    /// <summary>Vectors are saved among the colours; only colours are converted to the working colour space.</summary>
    private static void SetColor(Material material, string name, YamlMap value)
    {
        int index = material.shader.FindPropertyIndex(name);
        Color colour = ValueReaders.Color(value);
        if (index >= 0 && material.shader.GetPropertyType(index) == ShaderPropertyType.Vector) material.SetVector(name, colour);
        else material.SetColor(name, colour);
    }

    private static IEnumerable<(string Name, YamlMap Pair)> Pairs(NativeFields saved, string key) =>
        saved.Map.Maps(key).SelectMany(pair => pair.Entries.Select(e => (e.Key, pair)));
}
