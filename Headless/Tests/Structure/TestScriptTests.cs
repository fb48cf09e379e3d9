using System.Text.RegularExpressions;
using Headless.Checks;
using NUnit.Framework;

namespace Headless.Tests.Structure;

/// <summary>What ./test names is there: a filter that matches nothing passes in silence.</summary>
public sealed partial class TestScriptTests
{
    [Test]
    public void EveryClassInAFilterIsATestOfThePackages()
    {
        string root = Conformance.ReleaseBuildTests.FindUp("Headless/Play.slnx");
        HashSet<string> classes = [.. Directory.GetFiles(Path.Combine(root, "Packages"), "*Tests.cs", SearchOption.AllDirectories).Select(f => Path.GetFileNameWithoutExtension(f))];
        string[] named = [.. Assignments().Matches(File.ReadAllText(Path.Combine(root, "test"))).SelectMany(a => Class().Matches(a.Value)).Select(m => m.Value)];
        Assert.That(named, Has.Length.GreaterThan(20));
        Assert.That(named.Where(n => !classes.Contains(n)), Is.Empty);
    }

    [Test]
    public void EveryCheckIsMade()
    {
        string script = File.ReadAllText(Path.Combine(Conformance.ReleaseBuildTests.FindUp("Headless/Play.slnx"), "test"));
        string[] made = Regex.Match(script, "^shared='(.*?)'", RegexOptions.Multiline).Groups[1].Value.Split(' ');
        Assert.That(made, Is.EquivalentTo(CheckOptions.Flags.Single(f => f.Name == "--only").Choices!.Append("direct3d").Append("card").Append("pictures")));
    }

    [GeneratedRegex(@"^(?:direct3d|picture|card)_tests\+?='.*'$", RegexOptions.Multiline)]
    private static partial Regex Assignments();

    [GeneratedRegex(@"\b[A-Z]\w*Tests\b")]
    private static partial Regex Class();
}
