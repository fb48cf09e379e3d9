namespace Headless.Importers.Yaml;

/// <summary>A value in a Unity text file: <see cref="YamlScalar"/>, <see cref="YamlMap"/>, <see cref="YamlList"/> or a reference set by a prefab override.</summary>
public abstract class YamlNode(YamlPlace place)
{
    public YamlPlace Place { get; } = place;

    /// <summary>Values in it, itself included: what a copy costs.</summary>
    public virtual long Weight => 1;

    /// <summary>What it is, for messages.</summary>
    public abstract string Kind { get; }

    public abstract YamlNode Clone();
}

/// <summary>A plain or quoted scalar. Unity writes an empty value as an empty plain scalar.</summary>
public sealed class YamlScalar(string text, YamlPlace place = default) : YamlNode(place)
{
    public string Text { get; } = text;
    public bool IsEmpty => Text.Length == 0;
    public override string Kind => "a single value";

    public override YamlNode Clone() => this;
    public override string ToString() => Text;
}

public sealed class YamlList(YamlPlace place = default) : YamlNode(place)
{
    public List<YamlNode> Items { get; } = [];
    public override long Weight => 1 + Items.Sum(i => i.Weight);
    public override string Kind => "a list";

    public override YamlNode Clone()
    {
        var copy = new YamlList(Place);
        foreach (YamlNode item in Items) copy.Items.Add(item.Clone());
        return copy;
    }
}
