namespace Headless.Shaders.SpirV;

/// <summary>A SPIR-V module as a list of instructions.</summary>
internal sealed class SpirVModule
{
    private const uint Magic = 0x07230203;
    private const int HeaderWords = 5;

    private readonly uint _version;
    private readonly uint _generator;
    private uint _bound;

    public List<SpirVInstruction> Instructions { get; } = [];

    /// <exception cref="InvalidDataException">The bytes are not a whole SPIR-V module.</exception>
    public SpirVModule(byte[] bytes)
    {
        if (bytes.Length < HeaderWords * 4 || bytes.Length % 4 != 0)
        {
            throw new InvalidDataException($"a SPIR-V module of {bytes.Length} bytes is not whole");
        }
        uint[] words = new uint[bytes.Length / 4];
        Buffer.BlockCopy(bytes, 0, words, 0, bytes.Length);
        if (words[0] != Magic)
        {
            throw new InvalidDataException("not a SPIR-V module: wrong magic number");
        }
        _version = words[1];
        _generator = words[2];
        _bound = words[3];
        for (int at = HeaderWords; at < words.Length;)
        {
            int count = (int)(words[at] >> 16);
            if (count == 0 || at + count > words.Length)
            {
                throw new InvalidDataException($"SPIR-V instruction at word {at} runs past the end");
            }
            Instructions.Add(new SpirVInstruction((SpirVOp)(words[at] & 0xFFFF), words[(at + 1)..(at + count)]));
            at += count;
        }
    }

    public uint NewId() => _bound++;

    public byte[] ToBytes()
    {
        int length = HeaderWords + Instructions.Sum(i => i.Operands.Length + 1);
        uint[] words = new uint[length];
        words[0] = Magic;
        words[1] = _version;
        words[2] = _generator;
        words[3] = _bound;
        int at = HeaderWords;
        foreach (SpirVInstruction instruction in Instructions)
        {
            int count = instruction.Operands.Length + 1;
            words[at] = ((uint)count << 16) | (ushort)instruction.Op;
            instruction.Operands.CopyTo(words, at + 1);
            at += count;
        }
        byte[] bytes = new byte[length * 4];
        Buffer.BlockCopy(words, 0, bytes, 0, bytes.Length);
        return bytes;
    }
}
