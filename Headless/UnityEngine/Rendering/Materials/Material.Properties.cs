using System.Linq;
using System;
using Headless.Engine;
using Headless.Shaders;

namespace UnityEngine;

public partial class Material
{
    public Color color
    {
        get => GetColor(MainProperty("MainColor", "_Color"));
        set => SetColor(MainProperty("MainColor", "_Color"), value);
    }

    public Texture? mainTexture
    {
        get => GetTexture(MainProperty("MainTexture", "_MainTex"));
        set => SetTexture(MainProperty("MainTexture", "_MainTex"), value!);
    }

    public Vector2 mainTextureOffset
    {
        get => GetTextureOffset(MainProperty("MainTexture", "_MainTex"));
        set => SetTextureOffset(MainProperty("MainTexture", "_MainTex"), value);
    }

    public Vector2 mainTextureScale
    {
        get => GetTextureScale(MainProperty("MainTexture", "_MainTex"));
        set => SetTextureScale(MainProperty("MainTexture", "_MainTex"), value);
    }

    public Texture? GetTexture(string name) => GetTexture(ShaderNames.Id(name));

    public Texture? GetTexture(int nameID) => Sheet.Textures.GetValueOrDefault(nameID).Texture;

    public Vector2 GetTextureOffset(string name) => GetTextureOffset(ShaderNames.Id(name));

    public Vector2 GetTextureOffset(int nameID)
    {
        Vector4 st = ScaleOffset(nameID);
        return new Vector2(st.z, st.w);
    }

    public Vector2 GetTextureScale(string name) => GetTextureScale(ShaderNames.Id(name));

    public Vector2 GetTextureScale(int nameID)
    {
        Vector4 st = ScaleOffset(nameID);
        return new Vector2(st.x, st.y);
    }

    public void SetTextureOffset(string name, Vector2 value) => SetTextureOffset(ShaderNames.Id(name), value);

    public void SetTextureOffset(int nameID, Vector2 value)
    {
        Vector4 st = ScaleOffset(nameID);
        Sheet.SetVector(ScaleOffsetId(nameID), new Vector4(st.x, st.y, value.x, value.y));
    }

    public void SetTextureScale(string name, Vector2 value) => SetTextureScale(ShaderNames.Id(name), value);

    public void SetTextureScale(int nameID, Vector2 value)
    {
        Vector4 st = ScaleOffset(nameID);
        Sheet.SetVector(ScaleOffsetId(nameID), new Vector4(value.x, value.y, st.z, st.w));
    }

    public string[] GetTexturePropertyNames() =>
        [.. shader.Programs.Source.Properties.Where(ShaderProgramSet.IsTexture).Select(p => p.Name)];

    public int[] GetTexturePropertyNameIDs() => Array.ConvertAll(GetTexturePropertyNames(), ShaderNames.Id);

    public void SetColorArray(string name, Color[] values) => SetColorArray(ShaderNames.Id(name), values);

    public void SetColorArray(int nameID, Color[] values) => Sheet.SetVectors(nameID, Array.ConvertAll(values, c => (Vector4)c));

    internal ShaderValue? Value(int nameID) =>
        Sheet.Values.GetValueOrDefault(nameID) ?? shader.Programs.Defaults.Values.GetValueOrDefault(nameID);

    private static int ScaleOffsetId(int textureId) => ShaderNames.Id(ShaderNames.Name(textureId) + "_ST");

    private Vector4 ScaleOffset(int textureId) =>
        Sheet.Values.TryGetValue(ScaleOffsetId(textureId), out ShaderValue? value) ? value.Vector : new Vector4(1f, 1f, 0f, 0f);

    /// <summary>Colors of [HDR] properties are linear already; all others are given in sRGB.</summary>
    private void WriteColor(int nameID, Color value)
    {
        int index = shader.FindPropertyIndex(ShaderNames.Name(nameID));
        if (index >= 0 && shader.Programs.Source.Properties[index].Attributes.Contains("HDR"))
        {
            Sheet.SetVector(nameID, value);
        }
        else
        {
            Sheet.SetColor(nameID, value);
        }
    }

    private bool Has(int nameID, params ReadOnlySpan<ShaderValueKind> kinds) =>
        Value(nameID) is { } value && kinds.Contains(value.Kind);

    private int MainProperty(string attribute, string standardName)
    {
        foreach (ShaderProperty property in shader.Programs.Source.Properties)
        {
            if (property.Attributes.Contains(attribute))
            {
                return ShaderNames.Id(property.Name);
            }
        }

        return ShaderNames.Id(standardName);
    }
}
