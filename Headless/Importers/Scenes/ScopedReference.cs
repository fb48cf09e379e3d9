using Headless.Importers.Yaml;

namespace Headless.Importers.Scenes;

/// <summary>A reference set by an override: it means the file of the override, not that of the prefab it is set in.</summary>
public sealed class ScopedReference(YamlMap reference, SourceScope scope) : YamlNode(reference.Place)
{
    public YamlMap Reference { get; } = reference;
    public SourceScope Scope { get; } = scope;
    public override string Kind => "a reference";

    public override YamlNode Clone() => this;
    public override string ToString() => Reference.ToString();
}
