using System.Linq;
using NUnit.Framework;
using SphFluid.Editor;
using UnityEditor;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>The inspector of a simulation: few rows at first, units in labels, and one new start for a drag.</summary>
    public sealed class SimulationInspectorTests
    {
        private const int MostRows = 8;

        private FluidSimulation simulation;

        [SetUp]
        public void SetUp() => simulation = new GameObject("Fluid").AddComponent<FluidSimulation>();

        [TearDown]
        public void TearDown() => Object.DestroyImmediate(simulation.gameObject);

        [Test]
        public void AtMostEightRowsAreShownAtFirstAndAllOthersUnderAdvanced()
        {
            var edited = new SerializedObject(simulation);
            Assert.That(FluidSimulationEditor.Rows, Has.Length.LessThanOrEqualTo(MostRows));
            Assert.That(FluidSimulationEditor.Rows.First(), Is.EqualTo("liquid"));
            string[] all = FluidInspector.Visible(edited, new string[0]).ToArray();
            Assert.That(all.Take(FluidSimulationEditor.Rows.Length), Is.EqualTo(FluidSimulationEditor.Rows), "as in the script");
            Assert.That(FluidInspector.Visible(edited, FluidSimulationEditor.Rows), Is.EqualTo(all.Except(FluidSimulationEditor.Rows)));
        }

        [TestCase(FluidDomain.Box, "domainSize")]
        [TestCase(FluidDomain.Open, "farthestDistance")]
        public void TheSizeOfEitherDomainHasOneRow(FluidDomain domain, string field)
        {
            simulation.Domain = domain;
            var edited = new SerializedObject(simulation);
            Assert.That(FluidSimulationEditor.SizeOf(edited), Is.EqualTo(field));
            Assert.That(FluidSimulationEditor.Hidden(edited), Has.Member("farthestDistance"), "it is not under Advanced as well");
            InspectorDrawing.Draw(simulation);
        }

        [Test]
        public void UnfoldedItDrawsToo()
        {
            try
            {
                FluidSimulationEditor.showsAdvanced = FluidSimulationEditor.showsFigures = true;
                simulation.Liquid = PackageAssets.Liquid("Water");
                new GameObject("Volume").AddComponent<FluidVolume>().transform.SetParent(simulation.transform, false);
                InspectorDrawing.Draw(simulation);
            }
            finally
            {
                FluidSimulationEditor.showsAdvanced = FluidSimulationEditor.showsFigures = false;
            }
        }

        [TestCase("domainSize", "Domain Size (m)")]
        [TestCase("particleSpacing", "Particle Spacing (m)")]
        [TestCase("expectedSpeed", "Expected Speed (m/s)")]
        [TestCase("seed", "Seed")]
        public void LabelsHaveUnits(string field, string label) =>
            Assert.That(FluidInspector.Label(new SerializedObject(simulation).FindProperty(field)).text, Is.EqualTo(label));

        [Test]
        public void TheListOfMethodsBeginsWithAutomaticAndEndsWithTheThesis()
        {
            FluidMethodKind[] kinds = MethodField.Kinds;
            Assert.That(kinds.First(), Is.EqualTo(FluidMethodKind.Automatic));
            Assert.That(kinds.Skip(3), Is.EquivalentTo(new[] { FluidMethodKind.Thesis, FluidMethodKind.ThesisPrinted }));
            Assert.That(kinds, Is.Unique.And.EquivalentTo(System.Enum.GetValues(typeof(FluidMethodKind))));
        }

        [Test]
        public void StartsWaitWhileAHandleOrAFieldIsHeld([Values] bool handle)
        {
            var hold = new RestartHold(new Object[] { simulation });
            hold.Begin();
            Assert.That(simulation.StartsLater, Is.False, "a click waits for nothing");
            try
            {
                Hold(handle, true);
                hold.Begin();
                hold.Begin();
                EditorApplication.update?.Invoke();
                Assert.That(simulation.StartsLater, Is.True);
                Hold(handle, false);
                EditorApplication.update?.Invoke();
                Assert.That(simulation.StartsLater, Is.False);
                Hold(handle, true);
                hold.Begin();
                hold.End();
                Assert.That(simulation.StartsLater, Is.False, "the inspector is gone");
            }
            finally
            {
                Hold(handle, false);
                hold.End();
            }
        }

        private static void Hold(bool handle, bool held)
        {
            if (handle) GUIUtility.hotControl = held ? 1 : 0;
            else EditorGUIUtility.editingTextField = held;
        }
    }
}
