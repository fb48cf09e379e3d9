using System.Reflection;
using System.Text.RegularExpressions;
using NUnit.Framework;

namespace Headless.Tests.Conformance;

/// <summary>Headless/CONFORMANCE.md names a test in each line, and names every test of this folder.</summary>
public sealed partial class ConformanceListTests
{
    private static string[] Lines => [.. File.ReadLines(Path.Combine(ReleaseBuildTests.FindUp("Headless/CONFORMANCE.md"), "Headless", "CONFORMANCE.md"))
        .Where(l => l.StartsWith("- ", StringComparison.Ordinal))];

    private static HashSet<string> Tests => [.. typeof(ConformanceListTests).Assembly.GetTypes()
        .SelectMany(t => t.GetMethods(BindingFlags.Public | BindingFlags.Instance | BindingFlags.DeclaredOnly)
            .Where(m => m.GetCustomAttributes().Any(a => a is TestAttribute or TestCaseAttribute or TestCaseSourceAttribute))
            .Where(m => m.GetCustomAttribute<IgnoreAttribute>() is null)
            .Select(m => $"{t.Name}.{m.Name}"))];

    [Test]
    public void EveryLineNamesATest()
    {
        Assert.That(Lines, Has.Length.GreaterThan(50));
        Assert.That(Lines.Where(l => !Named().Matches(l).Any(m => Tests.Contains(m.Groups[1].Value))), Is.Empty);
        Assert.That(Lines.SelectMany(l => Named().Matches(l)).Select(m => m.Groups[1].Value).Where(n => !Tests.Contains(n)), Is.Empty);
    }

    [Test]
    public void EveryTestOfTheFolderIsInTheList()
    {
        string all = string.Join('\n', Lines);
        IEnumerable<string> here = typeof(ConformanceListTests).Assembly.GetTypes()
            .Where(t => t.Namespace == typeof(ConformanceListTests).Namespace && t != typeof(ConformanceListTests))
            .SelectMany(t => Tests.Where(n => n.StartsWith(t.Name + ".", StringComparison.Ordinal)));
        Assert.That(here.Where(n => !all.Contains($"`{n}`", StringComparison.Ordinal)), Is.Empty);
    }

    [GeneratedRegex("`([A-Za-z0-9]+\\.[A-Za-z0-9]+)`")]
    private static partial Regex Named();
}
