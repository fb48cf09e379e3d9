using System.Linq;
using System;

namespace Headless.Engine;

/// <summary>A constant buffer of a kernel with the values that fill it already looked up.</summary>
internal sealed class ComputeBlock
{
    private readonly byte[] bytes;
    private readonly ComputeValue[] values;
    private int packedVersion = -1;
    private bool usesGlobals;

    public ComputeBlock(BlockEntry entry, ComputeState state)
    {
        Entry = entry;
        bytes = new byte[entry.Size];
        values = [.. entry.Members.Select(m => state.Value(m.NameId))];
    }

    public BlockEntry Entry { get; }

    /// <summary>The packed bytes; packed anew only after a value of the shader has changed.</summary>
    public ReadOnlySpan<byte> Pack(ComputeState state)
    {
        if (packedVersion == state.Version && !usesGlobals)
        {
            return bytes;
        }

        packedVersion = state.Version;
        usesGlobals = false;
        for (int i = 0; i < values.Length; i++)
        {
            MemberEntry member = Entry.Members[i];
            if (values[i].IsSet)
            {
                ConstantPacker.WriteRaw(bytes, member.Constant.Offset, member.Constant.Size, values[i].Bytes);
            }
            else if (GlobalProperties.Sheet.Values.TryGetValue(member.NameId, out ShaderValue? global))
            {
                usesGlobals = true;
                ConstantPacker.Write(bytes, member.Constant, global);
            }
        }

        return bytes;
    }
}
