using Headless.Player.Output;
using NUnit.Framework;

namespace Headless.Tests.Player;

[Platform("Linux")]
public sealed class FilmViewerTests
{
    [TestCase(null, null, false)]
    [TestCase("", "", false)]
    [TestCase(":0", null, true)]
    [TestCase(null, "wayland-0", true)]
    public void ADisplayIsX11OrWayland(string? x11, string? wayland, bool there)
    {
        string? missing = FilmViewer.Missing(name => name == "DISPLAY" ? x11 : name == "WAYLAND_DISPLAY" ? wayland : null);
        Assert.That(missing is null, Is.EqualTo(there));
        if (!there) Assert.That(missing, Does.Contain("DISPLAY").And.Not.Contain("\n"));
    }
}
