using Headless.Importers.Scenes;
using Headless.Importers.Yaml;
using NUnit.Framework;

namespace Headless.Tests.Importers;

public sealed class PropertyPathTests
{
    private static YamlMap Parse(string text) => UnityYaml.ParseMap(text, "t");

    [Test]
    public void SetsAComponentOfAVector()
    {
        YamlMap map = Parse("m_LocalPosition: {x: 1, y: 2, z: 3}");
        PropertyPath.Set(map, "m_LocalPosition.y", new YamlScalar("7"), new ValueBudget("t"));
        Assert.That(map.Map("m_LocalPosition")!.Float("y"), Is.EqualTo(7));
        Assert.That(map.Map("m_LocalPosition")!.Float("z"), Is.EqualTo(3));
    }

    [Test]
    public void SetsAnElementAndAFieldOfAnElement()
    {
        YamlMap map = Parse("list:\n- {a: 1}\n- {a: 2}\nplain: [4, 5]");
        PropertyPath.Set(map, "list.Array.data[1].a", new YamlScalar("9"), new ValueBudget("t"));
        PropertyPath.Set(map, "plain.Array.data[0]", new YamlScalar("6"), new ValueBudget("t"));
        Assert.That(((YamlMap)map.List("list")[1]).Int("a"), Is.EqualTo(9));
        Assert.That(map.List("plain").Select(n => n.ToString()), Is.EqualTo(new[] { "6", "5" }));
    }

    [Test]
    public void ResizesWithCopiesOfTheLastElement()
    {
        YamlMap map = Parse("list:\n- {a: 1}\n- {a: 2}");
        PropertyPath.Set(map, "list.Array.size", new YamlScalar("4"), new ValueBudget("t"));
        Assert.That(map.List("list").Select(n => ((YamlMap)n).Int("a")), Is.EqualTo(new[] { 1, 2, 2, 2 }));
        PropertyPath.Set(map, "list.Array.size", new YamlScalar("1"), new ValueBudget("t"));
        Assert.That(map.List("list"), Has.Count.EqualTo(1));
    }

    [Test]
    public void MakesWhatIsMissing()
    {
        YamlMap map = Parse("a: 1");
        PropertyPath.Set(map, "b.c.Array.data[1].d", new YamlScalar("3"), new ValueBudget("t"));
        Assert.That(((YamlMap)map.Map("b")!.List("c")[1]).Int("d"), Is.EqualTo(3));
    }

    [Test]
    public void AnElementOfAPackedArrayIsAnError() =>
        Assert.That(() => PropertyPath.Set(Parse("ids: 0100000002000000"), "ids.Array.data[0]", new YamlScalar("3"), new ValueBudget("t")), Throws.TypeOf<FormatException>());
}
