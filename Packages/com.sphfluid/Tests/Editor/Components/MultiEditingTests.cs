using System.Linq;
using NUnit.Framework;
using SphFluid.Editor;
using UnityEditor;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Inspectors of several objects at once, and what inspectors may not do.</summary>
    public sealed class MultiEditingTests
    {
        private GameObject first, second;

        [SetUp]
        public void SetUp()
        {
            first = Make("First");
            second = Make("Second");
        }

        [TearDown]
        public void TearDown()
        {
            Object.DestroyImmediate(first);
            Object.DestroyImmediate(second);
        }

        [Test]
        public void EveryInspectorDrawsSeveralObjects()
        {
            foreach (MonoBehaviour component in first.GetComponents<MonoBehaviour>())
            {
                InspectorDrawing.Draw(component, second.GetComponent(component.GetType()));
            }
        }

        [Test]
        public void EveryInspectorOfThePackageAllowsSeveralObjects()
        {
            foreach (System.Type type in typeof(FluidSimulationEditor).Assembly.GetTypes())
                if (typeof(UnityEditor.Editor).IsAssignableFrom(type) && !type.IsAbstract)
                {
                    Assert.That(type.IsDefined(typeof(CanEditMultipleObjects), false), type.Name);
                }
        }

        [TestCase(FluidTimeStepMode.Automatic, FluidTimeStepMode.Automatic, true)]
        [TestCase(FluidTimeStepMode.Automatic, FluidTimeStepMode.Fixed, false)]
        [TestCase(FluidTimeStepMode.Fixed, FluidTimeStepMode.Automatic, false)]
        [TestCase(FluidTimeStepMode.Fixed, FluidTimeStepMode.Fixed, false)]
        public void AFieldIsHiddenOnlyIfNoneOfTheObjectsReadsIt(FluidTimeStepMode one, FluidTimeStepMode other, bool hidden)
        {
            first.GetComponent<FluidSimulation>().TimeStepMode = one;
            second.GetComponent<FluidSimulation>().TimeStepMode = other;
            Assert.That(FluidSimulationEditor.Hidden(Both<FluidSimulation>()).Contains("fixedTimeStep"), Is.EqualTo(hidden));
        }

        [TestCase(FluidMethodKind.Standard, FluidMethodKind.Standard, true)]
        [TestCase(FluidMethodKind.Standard, FluidMethodKind.Automatic, false)]
        [TestCase(FluidMethodKind.Automatic, FluidMethodKind.Automatic, false)]
        public void TheBudgetIsShownIfOneOfTheObjectsChoosesByIt(FluidMethodKind one, FluidMethodKind other, bool hidden)
        {
            first.GetComponent<FluidSimulation>().Method = one;
            second.GetComponent<FluidSimulation>().Method = other;
            foreach (string field in new[] { "frameBudget", "budgetFrameRate" })
            {
                Assert.That(FluidSimulationEditor.Hidden(Both<FluidSimulation>()).Contains(field), Is.EqualTo(hidden), field);
            }
        }

        [Test]
        public void GravityIsShownIfOneOfTheObjectsReadsIt()
        {
            Assert.That(FluidSimulationEditor.Hidden(Both<FluidSimulation>()), Has.Member("gravity"));
            second.GetComponent<FluidSimulation>().UseSceneGravity = false;
            Assert.That(FluidSimulationEditor.Hidden(Both<FluidSimulation>()), Has.No.Member("gravity"));
        }

        [Test]
        public void LooksThatDifferShowTheFieldsOfBoth()
        {
            Assert.That(FluidSurfaceRendererEditor.Hidden(Both<FluidSurfaceRenderer>()), Has.Member("color"));
            second.GetComponent<FluidSurfaceRenderer>().Look = FluidSurfaceLook.Opaque;
            Assert.That(FluidSurfaceRendererEditor.Hidden(Both<FluidSurfaceRenderer>()), Is.EqualTo(new[] { "m_Script", "ownLook" }));
        }

        [Test]
        public void ReadingTheSimulationOfAViewAssignsNothing()
        {
            var view = first.GetComponent<FluidSurfaceRenderer>();
            Assert.That(view.Simulation, Is.EqualTo(first.GetComponent<FluidSimulation>()));
            Assert.That(new SerializedObject(view).FindProperty("simulation").objectReferenceValue == null, Is.True);
            view.Simulation = second.GetComponent<FluidSimulation>();
            Assert.That(view.Simulation, Is.EqualTo(second.GetComponent<FluidSimulation>()));
        }

        [Test]
        public void ALiquidThatNothingDrawsIsNamedWithACure()
        {
            var simulation = first.GetComponent<FluidSimulation>();
            Assert.That(ViewRules.Check(simulation), Is.Null);
            foreach (FluidView view in first.GetComponents<FluidView>()) view.enabled = false;
            FluidMessage message = ViewRules.Check(simulation).Value;
            Assert.That(message.ToString(),
                Does.Contain("'First'").And.Contain("No component draws").And.Contain("Add a Fluid Surface Renderer"));
            FluidFix.For(message, simulation).Value.Apply();
            Assert.That(ViewRules.Check(simulation), Is.Null);
        }

        private SerializedObject Both<T>() where T : Component =>
            new SerializedObject(new Object[] { first.GetComponent<T>(), second.GetComponent<T>() });

        private static GameObject Make(string name)
        {
            var made = new GameObject(name);
            made.AddComponent<FluidSimulation>();
            made.AddComponent<FluidSurfaceRenderer>();
            made.AddComponent<FluidSurfaceMesh>();
            made.AddComponent<FluidDiagnostics>();
            made.AddComponent<FluidWhitewater>();
            made.AddComponent<FluidEmitter>();
            made.AddComponent<FluidVolume>();
            return made;
        }
    }
}
