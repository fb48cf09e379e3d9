using System.Text.Json;
using Headless.Player.Output;
using NUnit.Framework;

namespace Headless.Tests.Player;

public sealed class EnvironmentVersionsTests
{
    [Test]
    public void InstalledPackagesAreListedByName()
    {
        const string output = "installed spirv-tools 2023.1-2\nconfig-files wine64 8.0\ninstalled ffmpeg 7:5.1.9-0+deb12u1\nnot-installed npm \n";

        Assert.That(EnvironmentVersions.Parse(output), Is.EqualTo(new[] { ("ffmpeg", "7:5.1.9-0+deb12u1"), ("spirv-tools", "2023.1-2") }));
    }

    [Test]
    public void WithoutDpkgThereAreNoPackages() => Assert.That(EnvironmentVersions.Packages("no-such-dpkg-query"), Is.Empty);

    [Test]
    public void TheSystemAndDotnetAreAlwaysThere() =>
        Assert.That(EnvironmentVersions.Read().Select(v => v.Key), Is.SupersetOf(new[] { "os", "dotnet" }));

    [Test]
    public void TheSummaryHoldsThemAsAnObject()
    {
        string path = Path.GetTempFileName();
        IReadOnlyList<(string, string)> versions = [("os", "a"), ("libvulkan1", "1.3")];
        SummaryFile.Write(path, [("environment", versions)]);

        using JsonDocument json = JsonDocument.Parse(File.ReadAllText(path));
        Assert.That(json.RootElement.GetProperty("environment").GetProperty("libvulkan1").GetString(), Is.EqualTo("1.3"));
        File.Delete(path);
    }
}
