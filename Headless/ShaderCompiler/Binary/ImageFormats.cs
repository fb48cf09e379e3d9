using Headless.Shaders.SpirV;

namespace Headless.Shaders;

/// <summary>Fits the storage image formats of a binary to the textures that are bound.</summary>
/// <remarks>
/// HLSL names no format, so glslang writes the 32-bit one of the declared type (RWTexture2D&lt;float4&gt;: Rgba32f). D3D11 converts
/// to the texture's own; Vulkan needs the module to name it, or a device that stores without format.
/// </remarks>
public static class ImageFormats
{
    /// <summary>A binary whose RWTextures have the given formats by binding; the same object when nothing changes.</summary>
    /// <exception cref="ArgumentException">A format's kind (float, int, uint) is not the declared one.</exception>
    public static ShaderBinary With(ShaderBinary binary, IReadOnlyDictionary<int, ImageFormat> formats)
    {
        List<ShaderResource> changed = [];
        foreach (ShaderResource resource in binary.Resources)
        {
            if (resource.Kind == ResourceKind.RWTexture && formats.TryGetValue(resource.Binding, out ImageFormat format)
                && format != resource.Format)
            {
                CheckKind(resource, format);
                changed.Add(resource with { Format = format });
            }
        }
        if (changed.Count == 0)
        {
            return binary;
        }
        SpirVIndex index = new(new SpirVModule(binary.SpirV));
        foreach (ShaderResource resource in changed)
        {
            Change(index, resource);
        }
        AddCapability(index.Module, changed);
        byte[] bytes = index.Module.ToBytes();
        return binary with
        {
            SpirV = bytes,
            Hash = ShaderReflector.Hash(bytes),
            Resources = [.. binary.Resources.Select(r => changed.Find(c => c.Binding == r.Binding) ?? r)],
        };
    }

    /// <summary>"float", "int" or "uint": what a shader reads from an image of the format.</summary>
    public static string SampledType(ImageFormat format) => format switch
    {
        >= ImageFormat.Rgba32i and <= ImageFormat.R8i => "int",
        >= ImageFormat.Rgba32ui => "uint",
        _ => "float",
    };

    private static void CheckKind(ShaderResource resource, ImageFormat format)
    {
        if (format != ImageFormat.Unknown && SampledType(format) != resource.SampledType)
        {
            throw new ArgumentException(
                $"RWTexture '{resource.Name}' holds {resource.SampledType} but the texture's format {format} holds {SampledType(format)}");
        }
    }

    // The variable gets an image type of its own: others of the same HLSL type may keep their format.
    private static void Change(SpirVIndex index, ShaderResource resource)
    {
        SpirVModule module = index.Module;
        SpirVInstruction variable = index.Variables.Single(
            v => index.Find(v[1], SpirVDecoration.Binding) is { } b && b[2] == resource.Binding);
        SpirVInstruction pointer = index.Definition(variable[0]);
        SpirVInstruction image = index.Definition(pointer[2]);
        if (image.Op != SpirVOp.TypeImage)
        {
            throw new ArgumentException($"the format of the array of textures '{resource.Name}' cannot be changed");
        }
        SpirVInstruction? newImage = module.Instructions.Find(
            i => i.Op == SpirVOp.TypeImage && i[7] == (uint)resource.Format && i.Operands[1..7].SequenceEqual(image.Operands[1..7]));
        if (newImage is null)
        {
            newImage = image.Copy();
            newImage[0] = module.NewId();
            newImage[7] = (uint)resource.Format;
            module.Instructions.Insert(module.Instructions.IndexOf(image) + 1, newImage);
        }
        SpirVInstruction newPointer = pointer.Copy();
        newPointer[0] = module.NewId();
        newPointer[2] = newImage[0];
        module.Instructions.Insert(module.Instructions.IndexOf(variable), newPointer);
        variable[0] = newPointer[0];
        Retype(module, variable[1], image[0], newImage[0]);
        HoistAbove(module, newImage, newPointer);
    }

    // Loads of the variable yield the new image type; copies of those loads as well.
    private static void Retype(SpirVModule module, uint variable, uint oldType, uint newType)
    {
        HashSet<uint> holders = [variable];
        foreach (SpirVInstruction i in module.Instructions)
        {
            if (i.Op is SpirVOp.Load or SpirVOp.CopyObject && i[0] == oldType && holders.Contains(i[2]))
            {
                i[0] = newType;
                holders.Add(i[1]);
            }
        }
    }

    // A type that stood further down must come before the pointer that names it.
    private static void HoistAbove(SpirVModule module, SpirVInstruction image, SpirVInstruction pointer)
    {
        int at = module.Instructions.IndexOf(pointer);
        if (module.Instructions.IndexOf(image) > at)
        {
            module.Instructions.Remove(image);
            module.Instructions.Insert(at, image);
        }
    }

    private static void AddCapability(SpirVModule module, List<ShaderResource> changed)
    {
        if (changed.Any(r => NeedsExtendedFormats(r.Format)))
        {
            Require(module, 49);
        }
        if (changed.Any(r => r.Format == ImageFormat.Unknown))
        {
            Require(module, 55);
            Require(module, 56);
        }
    }

    private static bool NeedsExtendedFormats(ImageFormat format) => format is not (ImageFormat.Unknown or ImageFormat.Rgba32f
        or ImageFormat.Rgba16f or ImageFormat.R32f or ImageFormat.Rgba8 or ImageFormat.Rgba8Snorm or ImageFormat.Rgba32i
        or ImageFormat.Rgba16i or ImageFormat.Rgba8i or ImageFormat.R32i or ImageFormat.Rgba32ui or ImageFormat.Rgba16ui
        or ImageFormat.Rgba8ui or ImageFormat.R32ui);

    private static void Require(SpirVModule module, uint capability)
    {
        if (!module.Instructions.Exists(i => i.Op == SpirVOp.Capability && i[0] == capability))
        {
            module.Instructions.Insert(0, new SpirVInstruction(SpirVOp.Capability, capability));
        }
    }
}
