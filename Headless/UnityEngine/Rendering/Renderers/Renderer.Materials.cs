using System.Collections.Generic;
using System.Linq;
using System;
using Headless.Engine;

namespace UnityEngine;

public partial class Renderer
{
    private MaterialPropertyBlock? block;
    private MaterialPropertyBlock?[] blocks = [];

    public Material? sharedMaterial
    {
        get => sharedList.Length > 0 ? sharedList[0] : null;
        set
        {
            Material?[] list = sharedList.Length > 0 ? [.. sharedList] : [null];
            list[0] = value;
            sharedMaterials = list!;
        }
    }

    public Material[] sharedMaterials
    {
        get => [.. sharedList!];
        set
        {
            sharedList = [.. value ?? []];
            ownsMaterials = false;
        }
    }

    public Material? material
    {
        get => materials.Length > 0 ? sharedList[0] : null;
        set => sharedMaterial = value;
    }

    /// <summary>The renderer's own copies, made at the first call as in Unity.</summary>
    public Material[] materials
    {
        get
        {
            if (!ownsMaterials)
            {
                for (int i = 0; i < sharedList.Length; i++)
                {
                    if (sharedList[i] is { } original && original != null)
                    {
                        sharedList[i] = new Material(original) { name = original.name + " (Instance)" };
                    }
                }

                ownsMaterials = true;
            }

            return [.. sharedList!];
        }
        set => sharedMaterials = value;
    }

    public void GetMaterials(List<Material> m)
    {
        m.Clear();
        m.AddRange(materials);
    }

    public void GetSharedMaterials(List<Material> m)
    {
        m.Clear();
        m.AddRange(sharedMaterials);
    }

    public void SetMaterials(List<Material> materials) => sharedMaterials = materials.ToArray();

    public void SetSharedMaterials(List<Material> materials) => sharedMaterials = materials.ToArray();

    public bool HasPropertyBlock() => block is not null || Array.Exists(blocks, b => b is not null);

    public void SetPropertyBlock(MaterialPropertyBlock? properties) => block = Copy(properties);

    public void SetPropertyBlock(MaterialPropertyBlock? properties, int materialIndex)
    {
        if (materialIndex >= blocks.Length)
        {
            Array.Resize(ref blocks, materialIndex + 1);
        }

        blocks[materialIndex] = Copy(properties);
    }

    public void GetPropertyBlock(MaterialPropertyBlock properties) => Fill(properties, block);

    public void GetPropertyBlock(MaterialPropertyBlock properties, int materialIndex) =>
        Fill(properties, materialIndex < blocks.Length ? blocks[materialIndex] : null);

    internal PropertySheet? Block(int materialIndex) =>
        ((materialIndex < blocks.Length ? blocks[materialIndex] : null) ?? block)?.Sheet;

    private static MaterialPropertyBlock? Copy(MaterialPropertyBlock? source)
    {
        if (source is null || source.isEmpty)
        {
            return null;
        }

        var copy = new MaterialPropertyBlock();
        copy.Sheet.CopyFrom(source.Sheet);
        return copy;
    }

    private static void Fill(MaterialPropertyBlock target, MaterialPropertyBlock? source)
    {
        target.Clear();
        if (source is not null)
        {
            target.Sheet.CopyFrom(source.Sheet);
        }
    }
}
