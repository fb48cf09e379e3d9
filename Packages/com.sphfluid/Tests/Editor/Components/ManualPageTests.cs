using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Each component and asset has a page of the manual and an icon.</summary>
    public sealed class ManualPageTests
    {
        private const string Package = "Packages/com.sphfluid/";
        private const int IconSize = 64;

        private static readonly Regex Icon = new Regex("icon: {fileID: 2800000, guid: ([0-9a-f]{32}), type: 3}");

        [Test]
        public void AllComponentsAndAssetsAreLookedAt() =>
            Assert.That(Documented(),
                Is.SupersetOf(new[] { typeof(FluidSimulation), typeof(FluidSurfaceMesh), typeof(FluidProfile), typeof(FluidShaderSet) }));

        [Test]
        public void TheHelpIsAHeadingOfAPageThatExists([ValueSource(nameof(Documented))] Type type)
        {
            ManualPageAttribute page = Page(type);
            string file = FluidManual.FolderOf(page.Package) + page.Page + ".md";
            Assert.That(File.Exists(Path.GetFullPath(file)), $"{type.Name}: no {file}");
            if (page.Heading.Length > 0) Assert.That(ManualHeadings.Of(file), Has.Member(page.Heading), $"{type.Name}: {file}");
        }

        [Test]
        public void TheHelpOpensThePage([ValueSource(nameof(Documented))] Type type)
        {
            ManualPageAttribute page = Page(type);
            if (FluidManual.Site.Length > 0) Assert.That(page.URL, Does.StartWith(FluidManual.Site + page.Page));
            else Assert.That(File.Exists(new Uri(page.URL).LocalPath), page.URL);
        }

        [Test]
        public void AddressesOnASiteHaveTheHeading()
        {
            Assert.That(FluidManual.Address("tuning", "profile", site: "https://example.com/manual/"),
                Is.EqualTo("https://example.com/manual/tuning.md#profile"));
            Assert.That(FluidManual.Address("tuning", "", site: "https://example.com/manual/"),
                Is.EqualTo("https://example.com/manual/tuning.md"));
        }

        [Test]
        public void TheSiteIsThatOfThePackage()
        {
            Match url = Regex.Match(Text(Package + "package.json"), "\"documentationUrl\"\\s*:\\s*\"([^\"]*)\"");
            if (url.Success && FluidManual.Site.Length > 0) Assert.That(url.Groups[1].Value, Does.StartWith(FluidManual.Site));
            else Assert.That(url.Success, Is.EqualTo(FluidManual.Site.Length > 0), "documentationUrl of package.json and FluidManual.Site");
        }

        [Test]
        public void TheScriptHasAnIconOfItsOwn()
        {
            var owners = new Dictionary<string, Type>();
            foreach (Type type in Documented())
            {
                Match icon = Icon.Match(File.ReadAllText(Meta(type)));
                Assert.That(icon.Success, $"{type.Name}: no icon in its .meta");
                string path = AssetDatabase.GUIDToAssetPath(icon.Groups[1].Value);
                var picture = AssetDatabase.LoadAssetAtPath<Texture2D>(path);
                Assert.That(picture != null, $"{type.Name}: no picture at '{path}'");
                Assert.That((picture.width, picture.height), Is.EqualTo((IconSize, IconSize)), path);
                Assert.That(owners.ContainsKey(path), Is.False,
                    $"{type.Name} and {(owners.TryGetValue(path, out Type other) ? other.Name : "")} have {path}");
                owners.Add(path, type);
            }
        }

        [TestCase("The thesis's surface", "the-thesiss-surface")]
        [TestCase("Any material: Fluid Surface Mesh", "any-material-fluid-surface-mesh")]
        [TestCase("Size the box", "size-the-box")]
        public void AHeadingsLinkIsAsWebSitesMakeIt(string heading, string link) =>
            Assert.That(ManualHeadings.Link(heading), Is.EqualTo(link));

        // What is internal, nobody adds.
        private static Type[] Documented() => ProductTypes.All
            .Where(t => t.IsPublic && !t.IsAbstract &&
                (typeof(MonoBehaviour).IsAssignableFrom(t) || typeof(ScriptableObject).IsAssignableFrom(t))).ToArray();

        private static ManualPageAttribute Page(Type type)
        {
            var page = (ManualPageAttribute)Attribute.GetCustomAttribute(type, typeof(HelpURLAttribute));
            Assert.That(page, Is.Not.Null, $"{type.Name} has no [ManualPage]");
            return page;
        }

        private static string Meta(Type type)
        {
            string[] found = Directory.GetFiles(Path.GetFullPath(Package), type.Name + ".cs.meta", SearchOption.AllDirectories);
            Assert.That(found, Has.Length.EqualTo(1), type.Name);
            return found[0];
        }

        private static string Text(string path) => File.ReadAllText(Path.GetFullPath(path));
    }
}
