namespace Headless.Shaders.SpirV;

/// <summary>Removes what vkd3d says twice: the stride of an array type that two buffers share, which the validator refuses.</summary>
internal static class Decorations
{
    public static void RemoveRepeated(SpirVModule module)
    {
        HashSet<string> seen = [];
        module.Instructions.RemoveAll(i =>
            i.Op is SpirVOp.Decorate or SpirVOp.MemberDecorate && !seen.Add($"{i.Op} {string.Join(' ', i.Operands)}"));
    }
}
