using System;
using System.Linq;
using System.Reflection;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Names of the API are spelt as Unity spells them, and scenes with the earlier spelling keep their values.</summary>
    public sealed class ColorNameTests
    {
        private const string Prefab = "Packages/com.sphfluid/Tests/Editor/Components/OldColors.prefab";

        [Test]
        public void FieldsOfTheEarlierSpellingAreRead()
        {
            var old = AssetDatabase.LoadAssetAtPath<GameObject>(Prefab);
            Assert.That(old, Is.Not.Null, Prefab);
            var surface = old.GetComponent<FluidSurfaceRenderer>();
            Assert.That(surface.Color, Is.EqualTo(new Color(1f, 0.25f, 0f)));
            Assert.That(surface.Water.ColorAtOneMetre, Is.EqualTo(new Color(0.25f, 0.5f, 0.75f)));
            Assert.That(old.GetComponent<FluidGeometrySurfaceRenderer>().Color, Is.EqualTo(new Color(0f, 0.5f, 0.25f)));
            var particles = old.GetComponent<FluidParticleRenderer>();
            Assert.That(particles.Color, Is.EqualTo(new Color(0.75f, 0f, 0.25f)));
            Assert.That(particles.FastColor, Is.EqualTo(new Color(0f, 1f, 0.5f)));
            Assert.That(particles.ColorBySpeed, Is.True);
        }

        [Test]
        public void NoPublicNameHasColour()
        {
            string[] names = ProductTypes.All.Where(t => t.IsVisible).SelectMany(Names).Distinct().ToArray();
            Assert.That(names, Has.Member("ColorAtOneMetre"));
            Assert.That(names.Where(n => n.IndexOf("colour", StringComparison.OrdinalIgnoreCase) >= 0), Is.Empty);
        }

        private static string[] Names(Type type) =>
            type.GetMembers(BindingFlags.Public | BindingFlags.Instance | BindingFlags.Static | BindingFlags.DeclaredOnly)
            .Select(m => m.Name).Append(type.Name).ToArray();
    }
}
