using System.IO;
using System.Text.RegularExpressions;
using NUnit.Framework;

namespace SphFluid.Tests
{
    /// <summary>The version that kept costs are of.</summary>
    public sealed class FluidPackageTests
    {
        [Test]
        public void TheVersionIsThatOfThePackage()
        {
            string text = File.ReadAllText(Path.GetFullPath("Packages/com.sphfluid/package.json"));
            Assert.That(Regex.Match(text, "\"version\"\\s*:\\s*\"([^\"]*)\"").Groups[1].Value, Is.EqualTo(FluidPackage.Version));
        }
    }
}
