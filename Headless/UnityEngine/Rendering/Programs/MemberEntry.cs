using System;
using Headless.Shaders;

namespace Headless.Engine;

/// <summary>A member of a constant buffer with its property number.</summary>
internal sealed class MemberEntry(ConstantMember constant)
{
    public ConstantMember Constant { get; } = constant;
    public int NameId { get; } = ShaderNames.Id(constant.Name);

    /// <summary>The texture whose size a member called like "_MainTex_TexelSize" holds; -1 for others.</summary>
    public int TexelSizeOf { get; } = constant.Name.EndsWith("_TexelSize", StringComparison.Ordinal)
        ? ShaderNames.Id(constant.Name[..^"_TexelSize".Length])
        : -1;
}
