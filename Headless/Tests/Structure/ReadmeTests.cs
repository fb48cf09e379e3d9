using System.Text.RegularExpressions;
using NUnit.Framework;

namespace Headless.Tests.Structure;

/// <summary>The code of the README is that of a test, so that it does what the README says.</summary>
public sealed partial class ReadmeTests
{
    [Test]
    public void TheFirstLinesAreThoseOfATest()
    {
        string root = Conformance.ReleaseBuildTests.FindUp("Headless/Play.slnx");
        string code = Code().Match(File.ReadAllText(Path.Combine(root, "README.md")).ReplaceLineEndings("\n")).Groups[1].Value;
        string[] printed = Lines(code), tested = Lines(File.ReadAllText(Path.Combine(root, "Packages/com.sphfluid/Tests/Runtime/FirstLinesTests.cs")));
        Assert.That(printed, Has.Length.EqualTo(5));
        int first = Array.IndexOf(tested, printed[0]);
        Assert.That(first, Is.Not.Negative, $"no test has the line '{printed[0]}'");
        Assert.That(tested.Skip(first).Take(printed.Length), Is.EqualTo(printed));
    }

    [Test]
    public void TheAddressStandsOnce()
    {
        string root = Conformance.ReleaseBuildTests.FindUp("Headless/Play.slnx");
        IEnumerable<string> documents = Directory.GetFiles(root, "*.md").Concat(Directory.GetFiles(Path.Combine(root, "Packages"), "*.md", SearchOption.AllDirectories))
            .Where(f => Path.GetFileName(f) != "CONTRIBUTING.md");
        // A placeholder, or what the owner of a copy wrote in its place.
        string[] found = [.. documents.SelectMany(f => Address().Matches(File.ReadAllText(f)).Select(m => Path.GetRelativePath(root, f) + ": " + m.Value))];
        Assert.That(found, Has.Length.EqualTo(1));
        Assert.That(found[0], Does.StartWith("README.md: "));
    }

    [Test]
    public void PackagesHaveTheAddressOfTheReadmeOrNone()
    {
        string root = Conformance.ReleaseBuildTests.FindUp("Headless/Play.slnx");
        string address = Address().Match(File.ReadAllText(Path.Combine(root, "README.md"))).Value;
        foreach (string package in Directory.GetDirectories(Path.Combine(root, "Packages")))
        {
            string[] urls = [.. PackageUrl().Matches(File.ReadAllText(Path.Combine(package, "package.json"))).Select(m => m.Groups[1].Value)];
            Assert.That(urls, Has.Length.EqualTo(address.Contains("OWNER/") ? 0 : 3), package);
            Assert.That(urls, Is.All.StartsWith($"{address[..^4]}/blob/HEAD/Packages/{Path.GetFileName(package)}/"));
        }
    }

    private static string[] Lines(string text) => [.. text.Split('\n').Select(l => l.Trim()).Where(l => l.Length > 0)];

    [GeneratedRegex(@"https?://\S+\.git\b|\bOWNER/REPOSITORY\b")] private static partial Regex Address();
    [GeneratedRegex(@"""\w+Url"": ""(https:[^""]+)""")] private static partial Regex PackageUrl();
    [GeneratedRegex("^```csharp\n([\\s\\S]*?)^```", RegexOptions.Multiline)] private static partial Regex Code();
}
