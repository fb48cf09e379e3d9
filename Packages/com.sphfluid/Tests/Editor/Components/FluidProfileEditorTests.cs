using System.Linq;
using NUnit.Framework;
using SphFluid.Editor;
using UnityEditor;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>The inspector of a profile shows what the methods in use read.</summary>
    public sealed class FluidProfileEditorTests
    {
        private FluidProfile profile;
        private GameObject scene;

        [SetUp]
        public void SetUp() => profile = ScriptableObject.CreateInstance<FluidProfile>();

        [TearDown]
        public void TearDown()
        {
            Object.DestroyImmediate(scene);
            Object.DestroyImmediate(profile);
        }

        [Test]
        public void EveryFieldOfAMethodIsOneOfTheProfile([ValueSource(nameof(Kinds))] FluidMethodKind kind)
        {
            using (var edited = new SerializedObject(profile))
            {
                foreach (string field in FluidMethods.Get(kind).ProfileFields) Assert.That(edited.FindProperty(field), Is.Not.Null, field);
            }
        }

        [Test]
        public void AllFieldsShowWhereNoMethodIsInUse() => Assert.That(FluidProfileEditor.Unread(new FluidMethodKind[0]), Is.Empty);

        [Test]
        public void TheThesisMethodsFieldsHideForStandard()
        {
            Assert.That(FluidProfileEditor.Unread(new[] { FluidMethodKind.Standard }),
                Is.EqualTo(new[] { "substeps", "wallDistanceRatio", "wallStiffnessRatio", "wallDampingRatio", "thesisSwitches" }));
            Assert.That(FluidProfileEditor.Unread(new[] { FluidMethodKind.Standard, FluidMethodKind.Thesis }),
                Is.EqualTo(new[] { "substeps" }));
            Assert.That(FluidProfileEditor.Unread(new[] { FluidMethodKind.Standard, FluidMethodKind.Thesis, FluidMethodKind.Robust }),
                Is.Empty);
        }

        [Test]
        public void MethodsInUseAreThoseOfSimulationsWithTheProfile()
        {
            Assert.That(FluidProfileEditor.MethodsOf(new Object[] { profile }), Is.Empty);
            scene = new GameObject("Tank");
            scene.SetActive(false);
            var simulation = scene.AddComponent<FluidSimulation>();
            simulation.Method = FluidMethodKind.ThesisPrinted;
            Assert.That(FluidProfileEditor.MethodsOf(new Object[] { profile }), Is.Empty, "another profile");
            simulation.Profile = profile;
            Assert.That(FluidProfileEditor.MethodsOf(new Object[] { profile }), Is.EqualTo(new[] { FluidMethodKind.ThesisPrinted }));
        }

        [Test]
        public void TheInspectorDraws()
        {
            scene = new GameObject("Tank");
            scene.SetActive(false);
            scene.AddComponent<FluidSimulation>().Profile = profile;
            InspectorDrawing.Draw(profile);
        }

        private static FluidMethodKind[] Kinds() => FluidMethods.All.Select(m => m.Kind).ToArray();
    }
}
