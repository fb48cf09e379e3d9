using System.Text;
using Headless.Importers.Yaml;
using NUnit.Framework;

namespace Headless.Tests.Importers;

public sealed class XxHash64Tests
{
    // Ids that public projects' scene files hold for their models.
    [TestCase("Mesh", "default", -2432090755550338912)]
    [TestCase("Mesh", "Cube", -5495902117074765545)]
    [TestCase("Mesh", "Candy.001", 812695599402130866)]
    [TestCase("Material", "defaultMat", -3033667219593020291)]
    [TestCase("GameObject", "//RootNode/root", 919132149155446097)]
    [TestCase("Transform", "//RootNode/root/Transform", -8679921383154817045)]
    [TestCase("GameObject", "//RootNode", -927199367670048503)]
    [TestCase("Transform", "//RootNode", -4216859302048453862)]
    public void FileIdsAgreeWithTheEditors(string className, string name, long expected) =>
        Assert.That(XxHash64.FileId(className, name), Is.EqualTo(expected));

    // Published test vectors of the algorithm, seed 0.
    [TestCase("", "EF46DB3751D8E999")]
    [TestCase("a", "D24EC4F1A98C6E5B")]
    [TestCase("abc", "44BC2CF5AD770999")]
    [TestCase("Nobody inspects the spammish repetition", "FBCEA83C8A378BF1")]
    public void HashAgreesWithTheReference(string text, string expected) =>
        Assert.That(XxHash64.Hash(Encoding.ASCII.GetBytes(text)).ToString("X16"), Is.EqualTo(expected));
}
