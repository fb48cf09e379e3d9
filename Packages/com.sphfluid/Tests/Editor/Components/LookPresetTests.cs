using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>The presets of looks name fields that Fluid Surface Renderer has, with values that it takes.</summary>
    public sealed class LookPresetTests
    {
        private const string Folder = "Packages/com.sphfluid/Editor/Presets";

        private static readonly Regex Value = new Regex("propertyPath: (\\S+)\\n    value: (\\S+)\\n    objectReference: {fileID: 0}");
        private static readonly Regex Script = new Regex("m_ManagedTypePPtr: {fileID: 11500000, guid: ([0-9a-f]{32}), type: 3}");

        private GameObject holder;
        private FluidSurfaceRenderer drawing;

        [SetUp]
        public void SetUp()
        {
            holder = new GameObject("Surface");
            drawing = holder.AddComponent<FluidSurfaceRenderer>();
        }

        [TearDown]
        public void TearDown() => Object.DestroyImmediate(holder);

        [Test]
        public void ThereIsOneForEachLook() =>
            Assert.That(Presets(), Is.EqualTo(new[] { "Clear Water", "Honey", "Milk", "Oil", "River", "Sea" }));

        [Test]
        public void ItIsForTheSurfaceRenderer([ValueSource(nameof(Presets))] string name)
        {
            Match script = Script.Match(Text(name));
            Assert.That(script.Success, "the target's script");
            Assert.That(Path.GetFileName(AssetDatabase.GUIDToAssetPath(script.Groups[1].Value)), Is.EqualTo("FluidSurfaceRenderer.cs"));
        }

        [Test]
        public void EveryFieldThatItSetsExists([ValueSource(nameof(Presets))] string name)
        {
            IReadOnlyDictionary<string, float> values = Values(name);
            Assert.That(values.Count, Is.GreaterThan(5));
            using (var edited = new SerializedObject(drawing))
            {
                foreach (string path in values.Keys)
                {
                    SerializedProperty field = edited.FindProperty(Regex.Replace(path, "\\.[rgba]$", ""));
                    Assert.That(field, Is.Not.Null, path);
                    Assert.That(field.propertyType == SerializedPropertyType.Color, Is.EqualTo(Regex.IsMatch(path, "\\.[rgba]$")), path);
                }
            }
        }

        [Test]
        public void AWholeColourIsSet([ValueSource(nameof(Presets))] string name)
        {
            foreach (IGrouping<string, string> colour in Values(name).Keys.Where(p => Regex.IsMatch(p, "\\.[rgba]$"))
                .GroupBy(p => p.Substring(0, p.Length - 2)))
            {
                Assert.That(colour.Select(p => p[p.Length - 1]), Is.EqualTo("rgba"), colour.Key);
            }
        }

        [Test]
        public void ClearWaterIsWhatANewRendererHas()
        {
            IReadOnlyDictionary<string, float> values = Values("Clear Water");
            FluidWaterLook water = drawing.Water;
            Assert.That((FluidSurfaceLook)values["look"], Is.EqualTo(drawing.Look));
            Assert.That(Colour(values, "water.colorAtOneMetre"), Is.EqualTo(water.ColorAtOneMetre));
            Assert.That(Colour(values, "water.scattering"), Is.EqualTo(water.Scattering));
            Assert.That(new[] { values["water.visibility"], values["water.refraction"], values["water.smoothness"], values["water.shadow"],
                values["water.spray"] },
                Is.EqualTo(new[] { water.Visibility, water.Refraction, water.Smoothness, water.Shadow, water.Spray }));
        }

        [Test]
        public void MilkIsOpaqueAndTheOthersAreNot([ValueSource(nameof(Presets))] string name) =>
            Assert.That((FluidSurfaceLook)Values(name)["look"],
                Is.EqualTo(name == "Milk" ? FluidSurfaceLook.Opaque : FluidSurfaceLook.Water));

        private static string[] Presets() => Directory.GetFiles(Path.GetFullPath(Folder), "*.preset")
            .Select(Path.GetFileNameWithoutExtension)
            .OrderBy(n => n, System.StringComparer.Ordinal).ToArray();

        private static string Text(string name) => File.ReadAllText(Path.GetFullPath($"{Folder}/{name}.preset")).Replace("\r\n", "\n");

        private static IReadOnlyDictionary<string, float> Values(string name) => Value.Matches(Text(name)).Cast<Match>()
            .ToDictionary(m => m.Groups[1].Value, m => float.Parse(m.Groups[2].Value, CultureInfo.InvariantCulture));

        private static Color Colour(IReadOnlyDictionary<string, float> values, string field) =>
            new Color(values[field + ".r"], values[field + ".g"], values[field + ".b"], values[field + ".a"]);
    }
}
