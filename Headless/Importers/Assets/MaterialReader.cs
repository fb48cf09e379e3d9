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
        foreach (YamlNode keyword in f.Map.List("m_ValidKeywords").Concat(f.Map.List("m_InvalidKeywords"))) material.EnableKeyword(keyword.ToString()!);
        // Before 2021.2 the keywords were one string.
        foreach (string keyword in f.Text("m_ShaderKeywords").Split(' ', StringSplitOptions.RemoveEmptyEntries)) material.EnableKeyword(keyword);
        foreach (var (tag, value) in f.Map.Map("stringTagMap")?.Entries ?? []) material.SetOverrideTag(tag, value.ToString()!);
        foreach (YamlNode pass in f.Map.List("disabledShaderPasses")) material.SetShaderPassEnabled(pass.ToString()!, false);

        NativeFields saved = f.Nested("m_SavedProperties");
        foreach (var (name, value) in Pairs(saved, "m_Floats")) material.SetFloat(name, YamlValue.Float(value.ToString()!, name));
        foreach (var (name, value) in Pairs(saved, "m_Ints")) material.SetInteger(name, (int)YamlValue.Long(value.ToString()!, name));
        foreach (var (name, value) in Pairs(saved, "m_Colors")) SetColor(material, name, (YamlMap)value);
        foreach (var (name, value) in Pairs(saved, "m_TexEnvs"))
        {
            NativeFields texture = saved with { Map = (YamlMap)value };
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

    private static IEnumerable<KeyValuePair<string, YamlNode>> Pairs(NativeFields saved, string key) =>
        saved.Map.List(key).OfType<YamlMap>().SelectMany(m => m.Entries);
}
