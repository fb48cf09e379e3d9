using Headless.Importers;
using Headless.Importers.Project;
using NUnit.Framework;

namespace Headless.Tests.Importers;

public sealed class ProjectIndexTests
{
    private TemporaryProject project = null!;

    [SetUp]
    public void SetUp() => project = new TemporaryProject();

    [TearDown]
    public void TearDown() => project.Dispose();

    [Test]
    public void FindsAssetsAndEmbeddedPackagesByGuid()
    {
        string a = project.Add("Assets/A.txt", "a");
        project.Add("Packages/folder/package.json", """{"name": "com.example.thing"}""");
        string b = project.Add("Packages/folder/Runtime/B.txt", "b");
        var index = new ProjectIndex(project.Root);
        Assert.That(index.PathOf(a), Is.EqualTo("Assets/A.txt"));
        Assert.That(index.PathOf(b), Is.EqualTo("Packages/com.example.thing/Runtime/B.txt"));
        Assert.That(File.ReadAllText(index.FileOf(index.PathOf(b)!)), Is.EqualTo("b"));
        Assert.That(index.AssetPathOf(index.FileOf(index.PathOf(b)!)), Is.EqualTo(index.PathOf(b)));
        Assert.That(index.PathOf(TemporaryProject.Guid("nothing")), Is.Null);
    }

    [Test]
    public void SamplesAreLeftOutUntilMounted()
    {
        project.Add("Packages/p/package.json", """{"name": "p"}""");
        string one = project.Add("Packages/p/Samples~/One/scene.unity", ""), two = project.Add("Packages/p/Samples~/Two/scene.unity", "");
        var index = new ProjectIndex(project.Root);
        Assert.That(index.PathOf(one), Is.Null);
        index.MountSample("Packages/p/Samples~/One/scene.unity");
        Assert.That(index.PathOf(one), Is.EqualTo("Packages/p/Samples~/One/scene.unity"));
        Assert.That(index.PathOf(two), Is.Null);
    }

    [Test]
    public void EqualGuidsNameBothFiles()
    {
        project.Add("Assets/A.txt", "a");
        project.Add("Assets/B.txt", "b", guid: TemporaryProject.Guid("Assets/A.txt"));
        Assert.That(() => new ProjectIndex(project.Root), Throws.TypeOf<ImportException>().With.Message.StartsWith("'Assets/A.txt' and 'Assets/B.txt' have the same GUID"));
    }

    [Test]
    public void AssetsWithoutMetaAreListed()
    {
        File.WriteAllText(Path.Combine(project.Root, "Assets", "lost.txt"), "");
        Assert.That(new ProjectIndex(project.Root).MissingMetas, Is.EqualTo(new[] { "Assets/lost.txt" }));
    }

    [Test]
    public void ABadGuidIsAnError()
    {
        project.Add("Assets/A.txt", "a", guid: "XYZ");
        Assert.That(() => new ProjectIndex(project.Root), Throws.TypeOf<ImportException>().With.Message.Contains("32 lower-case hexadecimal digits"));
    }

    [Test]
    public void AFolderThatIsNoProjectIsAnError() =>
        Assert.That(() => new ProjectIndex(Path.Combine(project.Root, "Assets")), Throws.TypeOf<ImportException>().With.Message.Contains("is not a Unity project"));

    [Test]
    public void ScriptsBelongToTheNearestAssemblyDefinition()
    {
        project.Add("Assets/Game/Game.asmdef", """{"name": "Example.Game"}""");
        project.Add("Assets/Game/Tools/Tools.asmdef", """{"name": "Example.Tools", "includePlatforms": ["Editor"]}""");
        string tools = TemporaryProject.Guid("Assets/Game/Tools/Tools.asmdef");
        project.Add("Assets/More/More.asmref", "{\"reference\": \"GUID:" + tools + "\"}");
        var assemblies = new AssemblyDefinitions(new ProjectIndex(project.Root));
        Assert.That(assemblies.AssemblyOf("Assets/Game/Deep/Down/A.cs"), Is.EqualTo("Example.Game"));
        Assert.That(assemblies.AssemblyOf("Assets/Game/Tools/A.cs"), Is.EqualTo("Example.Tools"));
        Assert.That(assemblies.AssemblyOf("Assets/More/A.cs"), Is.EqualTo("Example.Tools"));
        Assert.That(assemblies.AssemblyOf("Assets/A.cs"), Is.EqualTo("Assembly-CSharp"));
        Assert.That(assemblies.AssemblyOf("Assets/Editor/A.cs"), Is.EqualTo("Assembly-CSharp-Editor"));
    }
}
