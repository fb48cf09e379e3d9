namespace Headless.Importers.Yaml;

/// <summary>A value in a Unity text file: <see cref="YamlScalar"/>, <see cref="YamlMap"/>, <see cref="YamlList"/> or a reference set by a prefab override.</summary>
public abstract class YamlNode
{
    public abstract YamlNode Clone();
}

/// <summary>A plain or quoted scalar. Unity writes an empty value as an empty plain scalar.</summary>
public sealed class YamlScalar(string text) : YamlNode
{
    public string Text { get; } = text;

    public override YamlNode Clone() => this;
    public override string ToString() => Text;
}

public sealed class YamlList : YamlNode
{
    public List<YamlNode> Items { get; } = [];

    public override YamlNode Clone()
    {
        var copy = new YamlList();
        foreach (YamlNode item in Items) copy.Items.Add(item.Clone());
        return copy;
    }
}
