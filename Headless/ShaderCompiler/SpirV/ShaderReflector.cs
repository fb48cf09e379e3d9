using System.Security.Cryptography;

namespace Headless.Shaders.SpirV;

/// <summary>Reads what the host must know from a rewritten module.</summary>
/// <param name="rawBuffers">Names of byte address buffers; in SPIR-V they look like structured buffers of uint.</param>
/// <param name="writeRegisters">Numbers n of register(un) that the source gives.</param>
/// <param name="sized">Names whose GetDimensions is called; glslang makes the stride a constant.</param>
internal sealed class ShaderReflector(
    SpirVIndex index, D3DLayout layout, IReadOnlySet<string> rawBuffers, IReadOnlySet<string> sized,
    IReadOnlyDictionary<string, int> writeRegisters)
{
    public ShaderBinary Read(ShaderStage stage, string entryPoint, IReadOnlyList<VertexInput> inputs)
    {
        IReadOnlyList<ShaderResource> resources = Numbered(Resources(), stage);
        (int x, int y, int z) = KernelFacts.GroupSize(index);
        int shared = KernelFacts.SharedBytes(index, layout);
        SemanticNames.Strip(index.Module);
        byte[] bytes = index.Module.ToBytes();
        return new ShaderBinary(stage, entryPoint, bytes, resources, inputs, x, y, z, shared, Hash(bytes))
        {
            InputPrimitive = stage == ShaderStage.Geometry ? InputPrimitive() : "",
        };
    }

    public static string Hash(byte[] spirV) => Convert.ToHexStringLower(SHA256.HashData(spirV));

    /// <summary>
    /// Gives what is written its register: the source's, or the next free one. In a pixel shader the render targets have the
    /// first ones.
    /// </summary>
    private List<ShaderResource> Numbered(List<ShaderResource> resources, ShaderStage stage)
    {
        HashSet<int> taken = [.. resources.Where(r => writeRegisters.ContainsKey(r.Name)).Select(r => writeRegisters[r.Name])];
        int next = stage == ShaderStage.Fragment ? StageInterface.Read(index, SpirVStorage.Output, perVertex: false).Count : 0;
        for (int i = 0; i < resources.Count; i++)
        {
            if (resources[i].Kind is not (ResourceKind.RWStructuredBuffer or ResourceKind.RWByteAddressBuffer or ResourceKind.RWTexture))
            {
                continue;
            }
            if (!writeRegisters.TryGetValue(resources[i].Name, out int register))
            {
                while (!taken.Add(next))
                {
                    next++;
                }
                register = next;
            }
            resources[i] = resources[i] with { Register = register };
        }
        return resources;
    }

    private List<ShaderResource> Resources()
    {
        List<ShaderResource> resources = [];
        foreach (SpirVInstruction variable in index.Variables)
        {
            if (index.Find(variable[1], SpirVDecoration.Binding) is not { } binding)
            {
                continue;
            }
            resources.Add(Resource(variable, (int)binding[2]));
        }
        return resources;
    }

    private ShaderResource Resource(SpirVInstruction variable, int binding)
    {
        uint type = index.Pointee(variable);
        int count = 1;
        if (index.Definition(type).Op == SpirVOp.TypeArray)
        {
            count = (int)index.ArrayLength(index.Definition(type));
            type = index.Definition(type)[1];
        }
        SpirVInstruction definition = index.Definition(type);
        string name = index.Name(variable[1]);
        ShaderResource resource = definition.Op switch
        {
            SpirVOp.TypeSampler => new ShaderResource(name, ResourceKind.Sampler, binding, 0, 0, [], "")
            {
                Comparison = IsComparison(variable[1]),
            },
            SpirVOp.TypeImage => Image(name, binding, definition),
            _ when index.Has(type, SpirVDecoration.Block) && (SpirVStorage)variable[2] == SpirVStorage.Uniform
                => ConstantBuffer(name, binding, type, variable[1]),
            _ => StorageBuffer(name, binding, type),
        };
        return resource with { Count = count };
    }

    private ShaderResource ConstantBuffer(string name, int binding, uint type, uint variable)
    {
        string blockName = name.Length > 0 ? name : index.Name(type);
        IReadOnlyList<ConstantMember> members = new ConstantMembers(index, layout, ReadMembers(variable)).Read(type);
        int size = members.Max(m => m.Offset + m.Size);
        return new ShaderResource(
            blockName == "$Global" ? "$Globals" : blockName, ResourceKind.ConstantBuffer, binding, (size + 15) / 16 * 16, 0, members, "");
    }

    private HashSet<uint> ReadMembers(uint variable) =>
    [
        .. index.Module.Instructions.Where(i => i.Op is SpirVOp.AccessChain or SpirVOp.InBoundsAccessChain && i[2] == variable)
            .Select(i => index.Definition(i[3])[2]),
    ];

    private ShaderResource StorageBuffer(string name, int binding, uint type)
    {
        if (name.EndsWith("@count", StringComparison.Ordinal))
        {
            return new ShaderResource(name, ResourceKind.Counter, binding, 0, 0, [], "");
        }
        bool readOnly = index.Find(type, 0, SpirVDecoration.NonWritable) is not null;
        bool raw = rawBuffers.Contains(name);
        uint array = index.Definition(type)[1];
        if (layout.ChangedStrides.Contains(array) && sized.Contains(name))
        {
            throw new InvalidDataException(
                $"'{name}.GetDimensions' would yield a stride that is not D3D11's; give the count and the stride as uniforms");
        }
        int stride = (int)index.Find(array, SpirVDecoration.ArrayStride)![2];
        ResourceKind kind = (raw, readOnly) switch
        {
            (true, true) => ResourceKind.ByteAddressBuffer,
            (true, false) => ResourceKind.RWByteAddressBuffer,
            (false, true) => ResourceKind.StructuredBuffer,
            _ => ResourceKind.RWStructuredBuffer,
        };
        return new ShaderResource(name, kind, binding, 0, raw ? 4 : stride, [], "");
    }

    private ShaderResource Image(string name, int binding, SpirVInstruction image)
    {
        // OpTypeImage: id, sampled type, dim, depth, arrayed, multisampled, sampled (2 = storage), format
        bool storage = image[6] == 2;
        if (image[2] == 5)
        {
            throw new InvalidDataException(
                $"'{name}' is a typed buffer (Buffer<T>, RWBuffer<T>), which is not supported; use a structured buffer");
        }
        string dimension = image[2] switch { 0 => "1D", 1 => "2D", 2 => "3D", 3 => "Cube", _ => "Other" };
        dimension += (image[4] == 1 ? "Array" : "") + (image[5] == 1 ? "MS" : "");
        SpirVInstruction sampled = index.Definition(image[1]);
        return new ShaderResource(
            name, storage ? ResourceKind.RWTexture : ResourceKind.Texture, binding, 0, 0, [], dimension)
        {
            Format = storage ? (ImageFormat)image[7] : ImageFormat.Unknown,
            SampledType = sampled.Op == SpirVOp.TypeFloat ? "float" : sampled[2] == 1 ? "int" : "uint",
        };
    }

    // A sampler compares when an image is joined with it for a depth-reference instruction.
    private bool IsComparison(uint sampler)
    {
        HashSet<uint> holders = [sampler];
        foreach (SpirVInstruction i in index.Module.Instructions)
        {
            switch (i.Op)
            {
                case SpirVOp.Load or SpirVOp.CopyObject or SpirVOp.AccessChain when holders.Contains(i[2]):
                case SpirVOp.SampledImage when holders.Contains(i[3]):
                    holders.Add(i[1]);
                    break;
                case SpirVOp.ImageSampleDrefImplicitLod or SpirVOp.ImageSampleDrefExplicitLod
                    or SpirVOp.ImageSampleProjDrefImplicitLod or SpirVOp.ImageSampleProjDrefExplicitLod or SpirVOp.ImageDrefGather
                    when holders.Contains(i[2]):
                    return true;
            }
        }
        return false;
    }

    private string InputPrimitive() =>
        KernelFacts.Mode(index, SpirVExecutionMode.InputPoints) is not null ? "point"
        : KernelFacts.Mode(index, SpirVExecutionMode.InputLines) is not null ? "line"
        : KernelFacts.Mode(index, SpirVExecutionMode.Triangles) is not null ? "triangle"
        : throw new InvalidDataException("geometry input with adjacency is not supported; use point, line or triangle");
}
