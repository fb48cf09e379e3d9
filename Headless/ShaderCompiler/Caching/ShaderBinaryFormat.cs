using Headless.Shaders.SpirV;

namespace Headless.Shaders;

/// <summary>Bytes of <see cref="ShaderBinary"/> lists in cache files.</summary>
internal static class ShaderBinaryFormat
{
    public static void Write(BinaryWriter writer, IReadOnlyList<ShaderBinary> binaries)
    {
        writer.Write(binaries.Count);
        foreach (ShaderBinary binary in binaries)
        {
            writer.Write((int)binary.Stage);
            writer.Write(binary.EntryPoint);
            writer.Write(binary.Hash);
            writer.Write(binary.InputPrimitive);
            writer.Write(binary.GroupX);
            writer.Write(binary.GroupY);
            writer.Write(binary.GroupZ);
            writer.Write(binary.SharedBytes);
            WriteList(writer, binary.Resources, WriteResource);
            WriteList(writer, binary.Inputs, WriteInput);
            writer.Write(binary.SpirV.Length);
            writer.Write(binary.SpirV);
        }
    }

    /// <exception cref="InvalidDataException">The bytes are damaged.</exception>
    public static IReadOnlyList<ShaderBinary> Read(BinaryReader reader)
    {
        int count = reader.ReadInt32();
        List<ShaderBinary> binaries = [];
        for (int i = 0; i < count; i++)
        {
            ShaderStage stage = (ShaderStage)reader.ReadInt32();
            string entry = reader.ReadString();
            string hash = reader.ReadString();
            string primitive = reader.ReadString();
            int x = reader.ReadInt32();
            int y = reader.ReadInt32();
            int z = reader.ReadInt32();
            int shared = reader.ReadInt32();
            List<ShaderResource> resources = ReadList(reader, ReadResource);
            List<VertexInput> inputs = ReadList(reader, ReadInput);
            byte[] spirV = reader.ReadBytes(reader.ReadInt32());
            if (ShaderReflector.Hash(spirV) != hash)
            {
                throw new InvalidDataException("damaged cache entry");
            }
            binaries.Add(new ShaderBinary(stage, entry, spirV, resources, inputs, x, y, z, shared, hash) { InputPrimitive = primitive });
        }
        return binaries;
    }

    private static void WriteResource(BinaryWriter writer, ShaderResource resource)
    {
        writer.Write(resource.Name);
        writer.Write((int)resource.Kind);
        writer.Write(resource.Binding);
        writer.Write(resource.Size);
        writer.Write(resource.Stride);
        WriteList(writer, resource.Members, WriteMember);
        writer.Write(resource.Dimension);
        writer.Write((int)resource.Format);
        writer.Write(resource.SampledType);
        writer.Write(resource.Comparison);
        writer.Write(resource.Count);
        writer.Write(resource.Register);
    }

    private static ShaderResource ReadResource(BinaryReader reader) =>
        new(reader.ReadString(), (ResourceKind)reader.ReadInt32(), reader.ReadInt32(), reader.ReadInt32(), reader.ReadInt32(),
            ReadList(reader, ReadMember), reader.ReadString())
        {
            Format = (ImageFormat)reader.ReadInt32(),
            SampledType = reader.ReadString(),
            Comparison = reader.ReadBoolean(),
            Count = reader.ReadInt32(),
            Register = reader.ReadInt32(),
        };

    private static void WriteMember(BinaryWriter writer, ConstantMember member)
    {
        writer.Write(member.Name);
        writer.Write(member.Offset);
        writer.Write(member.Size);
        writer.Write(member.ArrayLength);
        writer.Write(member.ArrayStride);
        writer.Write(member.Type);
        writer.Write(member.IsMatrix);
        writer.Write(member.Rows);
        writer.Write(member.Columns);
        writer.Write(member.RowMajor);
        writer.Write(member.IsRead);
    }

    private static ConstantMember ReadMember(BinaryReader reader) =>
        new(reader.ReadString(), reader.ReadInt32(), reader.ReadInt32(), reader.ReadInt32(), reader.ReadInt32(),
            reader.ReadString(), reader.ReadBoolean(), reader.ReadInt32(), reader.ReadInt32())
        {
            RowMajor = reader.ReadBoolean(),
            IsRead = reader.ReadBoolean(),
        };

    private static void WriteInput(BinaryWriter writer, VertexInput input)
    {
        writer.Write(input.Semantic);
        writer.Write(input.Location);
        writer.Write(input.Components);
        writer.Write(input.Integer);
    }

    private static VertexInput ReadInput(BinaryReader reader) =>
        new(reader.ReadString(), reader.ReadInt32(), reader.ReadInt32(), reader.ReadBoolean());

    private static void WriteList<T>(BinaryWriter writer, IReadOnlyList<T> items, Action<BinaryWriter, T> write)
    {
        writer.Write(items.Count);
        foreach (T item in items)
        {
            write(writer, item);
        }
    }

    private static List<T> ReadList<T>(BinaryReader reader, Func<BinaryReader, T> read)
    {
        int count = reader.ReadInt32();
        List<T> items = [];
        for (int i = 0; i < count; i++)
        {
            items.Add(read(reader));
        }
        return items;
    }
}
