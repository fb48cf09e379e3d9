using System.Text;

namespace Headless.Shaders.SpirV;

/// <summary>Names the entry point of a module; it has only one.</summary>
internal static class EntryPointName
{
    // OpEntryPoint: execution model, function, name, interface variables
    private const int NameOperand = 2;

    public static void Set(SpirVModule module, string name)
    {
        SpirVInstruction entry = module.Instructions.Find(i => i.Op == SpirVOp.EntryPoint)!;
        string old = entry.Text(NameOperand);
        if (old != name)
        {
            entry.Operands =
                [.. entry.Operands[..NameOperand], .. Words(name), .. entry.Operands[(NameOperand + Words(old).Length)..]];
        }
    }

    private static uint[] Words(string text)
    {
        byte[] bytes = Encoding.UTF8.GetBytes(text);
        uint[] words = new uint[bytes.Length / 4 + 1];
        Buffer.BlockCopy(bytes, 0, words, 0, bytes.Length);
        return words;
    }
}
