namespace Headless.Shaders.SpirV;

/// <summary>Removes the HLSL semantic strings, for which a device would need VK_GOOGLE_hlsl_functionality1.</summary>
internal static class SemanticNames
{
    private static readonly HashSet<string> Extensions = ["SPV_GOOGLE_hlsl_functionality1", "SPV_GOOGLE_user_type"];

    public static void Strip(SpirVModule module) => module.Instructions.RemoveAll(i =>
        i.Op is SpirVOp.DecorateString or SpirVOp.MemberDecorateString
        || (i.Op == SpirVOp.DecorateId && (SpirVDecoration)i[1] == SpirVDecoration.CounterBuffer)
        || (i.Op == SpirVOp.Extension && Extensions.Contains(i.Text(0))));
}
