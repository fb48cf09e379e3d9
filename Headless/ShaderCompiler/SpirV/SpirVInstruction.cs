namespace Headless.Shaders.SpirV;

/// <summary>One instruction; operands are all words after the first, result type and result id included.</summary>
internal sealed class SpirVInstruction(SpirVOp op, params uint[] operands)
{
    public SpirVOp Op { get; } = op;
    public uint[] Operands { get; set; } = operands;

    public uint this[int index]
    {
        get => Operands[index];
        set => Operands[index] = value;
    }

    /// <summary>A nul-terminated UTF-8 string that begins at an operand.</summary>
    public string Text(int first)
    {
        byte[] bytes = new byte[(Operands.Length - first) * 4];
        Buffer.BlockCopy(Operands, first * 4, bytes, 0, bytes.Length);
        int end = Array.IndexOf(bytes, (byte)0);
        return System.Text.Encoding.UTF8.GetString(bytes, 0, end < 0 ? bytes.Length : end);
    }

    public SpirVInstruction Copy() => new(Op, (uint[])Operands.Clone());
}
