using System.Linq;
using Headless.Shaders;

namespace Headless.Engine;

/// <summary>A constant buffer of a stage.</summary>
internal sealed class BlockEntry(ShaderResource resource)
{
    public int NameId { get; } = ShaderNames.Id(resource.Name);
    public string Name { get; } = resource.Name;
    public int Binding { get; } = resource.Binding;
    public int Size { get; } = resource.Size;
    public MemberEntry[] Members { get; } = [.. resource.Members.Select(m => new MemberEntry(m))];
}
