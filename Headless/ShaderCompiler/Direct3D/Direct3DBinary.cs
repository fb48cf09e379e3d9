using Headless.Shaders.SpirV;

namespace Headless.Shaders.Direct3D;

/// <summary>Makes a finished binary of a kernel that FXC compiled and vkd3d-compiler translated.</summary>
/// <remarks>
/// vkd3d names a variable by its register ("t0", "u3", "cb1_0"); what the source calls it, and what a constant buffer holds, stands
/// in the shader's resource definitions. Constant buffers come as arrays of float4 and so need no layout.
/// </remarks>
internal static class Direct3DBinary
{
    /// <exception cref="InvalidDataException">A resource that the headless player does not support.</exception>
    public static ShaderBinary Build(StageJob job, byte[] shader, byte[] spirV)
    {
        ResourceDefinitions definitions = new(DxbcContainer.Chunk(shader, "RDEF"));
        SpirVModule module = new(spirV);
        Decorations.RemoveRepeated(module);
        TexelBuffers.MakeStorage(module);
        FloatConversions.Clamp(module);
        Contractions.Forbid(module);
        SpirVIndex index = new(module);
        DescriptorNumbers.Assign(index, set: 0);
        List<ShaderResource> resources = [.. Bound(index).Select(v => Resource(index, definitions, v))];
        EntryPointName.Set(module, job.EntryPoint);
        byte[] bytes = module.ToBytes();
        (int x, int y, int z) = KernelFacts.GroupSize(index);
        int shared = KernelFacts.SharedBytes(index, new D3DLayout(index));
        return new ShaderBinary(job.Stage, job.EntryPoint, bytes, resources, [], x, y, z, shared, ShaderReflector.Hash(bytes));
    }

    private static IEnumerable<SpirVInstruction> Bound(SpirVIndex index) =>
        index.Variables.Where(v => index.Find(v[1], SpirVDecoration.Binding) is not null);

    private static ShaderResource Resource(SpirVIndex index, ResourceDefinitions definitions, SpirVInstruction variable)
    {
        string name = index.Name(variable[1]);
        string register = name.StartsWith("cb", StringComparison.Ordinal) ? name.Split('_')[0] : name;
        DxbcResource found = definitions.Resources.FirstOrDefault(r => r.Register == register)
            ?? throw new InvalidDataException($"the register {register} has no name in the Direct3D shader");
        (int size, IReadOnlyList<ConstantMember> members) =
            found.Kind == ResourceKind.ConstantBuffer ? definitions.Buffers[found.Name] : (0, []);
        int binding = (int)index.Find(variable[1], SpirVDecoration.Binding)![2];
        return new ShaderResource(found.Name, found.Kind, binding, size, found.Stride, members, found.Dimension)
        {
            Format = found.Kind == ResourceKind.RWTexture ? (ImageFormat)index.Definition(index.Pointee(variable))[7] : ImageFormat.Unknown,
            SampledType = found.SampledType,
            Comparison = found.Comparison,
            Count = found.Count,
        };
    }
}
